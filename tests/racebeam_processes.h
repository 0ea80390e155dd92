// Which processes a run of the program has left: found by a mark in their environment, whoever
// their parent is by now.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/program.h"

namespace racebeam {

class MarkedProcesses {
 public:
  /// For Program::Setting::environment.
  std::string mark() const { return mark_; }
  /// Those that live now.
  int count() const {
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      found += read_file(entry.path() / "environ").find(mark_) != std::string::npos;
    }
    return found;
  }
  /// Whether there are so many within a minute.
  bool become(int wanted) const {
    for (int n = 0; n < 6000; ++n, usleep(10'000))
      if (count() == wanted) return true;
    return false;
  }

 private:
  static std::string next() {
    static int serial = 0;
    return "RACEBEAM_TEST_MARK=" + std::to_string(getpid()) + "_" + std::to_string(++serial) + "_";
  }
  const std::string mark_ = next();
};

}  // namespace racebeam
