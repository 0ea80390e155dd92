// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/project_folder.h"

#include <algorithm>
#include <filesystem>

#include "tb/base/errors.h"

namespace racebeam {

namespace fs = std::filesystem;

std::string program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().string();
}

std::string project_folder() {
  std::error_code error;
  const fs::path installed = (fs::path(program_folder()) / RACEBEAM_DATA).lexically_normal();
  return fs::exists(installed, error) ? installed.string() : RACEBEAM_ROOT;
}

std::string rtl_folder() {
  std::error_code error;
  const std::string folder = project_folder() + "/rtl";
  if (!fs::exists(folder, error))
    throw MissingTool("racebeam is installed without its RTL: there is no " + folder +
                      "; `cmake --install BUILD --component rtl` adds it");
  return folder;
}

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
