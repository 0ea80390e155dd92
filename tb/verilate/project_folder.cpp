// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/project_folder.h"

#include <filesystem>

namespace racebeam {

namespace fs = std::filesystem;

std::string project_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = (program / "../share/racebeam").lexically_normal();
  return fs::exists(installed / "rtl", error) ? installed.string() : RACEBEAM_ROOT;
}

std::string rtl_folder() { return project_folder() + "/rtl"; }

}  // namespace racebeam
