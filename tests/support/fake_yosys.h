// A yosys that does what a test wants.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tb/base/whole_file.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

/// From now on PATH has one whose work is `work`, commands of a shell; it works in the folder that
/// scripts/netlist has made.
class FakeYosys {
 public:
  static constexpr const char* Version = "Yosys 0.99 (fake)";
  /// Never ends, and neither does what it has started.
  static constexpr const char* Hangs =
      "sleep 1000 &\necho $! >$0.new\nmv $0.new $0.id\nwhile :; do wait; done\n";
  /// 2 flip-flops and 5 cells.
  static constexpr const char* Counts =
      "printf '=== x ===\\n   Number of cells:   5\\n     $_DFF_P_   2\\n' >out\n";

  explicit FakeYosys(const std::string& work,
                     const std::string& version = std::string("echo '") + Version + "'") {
    std::ofstream(file_) << "#!/bin/sh\nif [ \"$1\" = -V ]; then\n" + version + "\nexit\nfi\n" +
                                work;
    std::filesystem::permissions(file_, std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path() + ":" + std::getenv("PATH")).c_str(), 1);
  }

  /// One that hangs has begun.
  bool hangs() const { return std::filesystem::exists(file_ + ".id"); }
  /// What it has started is gone, within a minute.
  bool is_gone() const {
    const std::string process = "/proc/" + std::to_string(std::stoi(whole_file(file_ + ".id")));
    for (int n = 0; n < 6000; ++n, usleep(10'000))
      if (whole_file(process + "/cmdline").empty()) return true;
    return false;
  }

 private:
  ScratchFolder folder_;
  const std::string file_ = folder_ / "yosys";
};

}  // namespace racebeam
