// libFuzzer target: no list of sources makes its reader crash or hang, and all that it names is
// there.
//
// The reader follows what lists name, so there is a folder with something to name.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tb/base/errors.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/source_list.h"
#include "tests/fuzz/stand_in_engines.h"

// Nobody verilates.
racebeam::RtlSyntax racebeam::read_rtl_syntax(const RtlSources&) { std::abort(); }

namespace {

namespace fs = std::filesystem;
using namespace racebeam;

/// In memory, if the machine has that, and gone at the end.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    const fs::path above = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    std::string name = (above / "racebeam_fuzz.XXXXXX").string();
    check(mkdtemp(name.data()) != nullptr);
    path_ = name;
    fs::create_directories(path_ / "rtl");
    fs::create_directories(path_ / "none");
    for (const char* file : {"a.sv", "b.v", "rtl/pkg.sv", "rtl/c.sv"}) std::ofstream(path_ / file);
    std::ofstream(path_ / "more.f") << "b.v\n-f list.f\n";
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  std::string list() const { return (path_ / "list.f").string(); }

 private:
  fs::path path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  std::ofstream(folder.list()) << text_of(data, size);
  try {
    const RtlSources sources = read_source_list("unit", folder.list());
    for (const std::string& file : sources.files) check(fs::is_regular_file(file));
  } catch (const UsageError&) {
  }
  return 0;
}
