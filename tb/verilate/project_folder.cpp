// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/project_folder.h"

#include <algorithm>
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

std::vector<std::string> rtl_folders() {
  std::vector<std::string> folders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(rtl_folder(), error))
    if (entry.is_directory(error)) folders.push_back(entry.path().string());
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::string rtl_file(const std::string& module) {
  std::error_code error;
  for (const std::string& folder : rtl_folders())
    if (const fs::path file = fs::path(folder) / (module + ".sv"); fs::exists(file, error))
      return file.string();
  return rtl_folder() + "/" + module + ".sv";
}

}  // namespace racebeam
