// Where the project's own files are: RTL, scenes, what plug-ins are compiled with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// Where the program that runs lies.
std::string program_folder();

/// The folder with scenes/, rtl/ and sc/: where they are installed with the program, or the
/// sources.
std::string project_folder();

/// The folder of this project's RTL, with its info.yaml. It throws MissingTool if the program is
/// installed without, and so do the others.
std::string rtl_folder();
/// The folders in it: of each engine, and of what they share.
std::vector<std::string> rtl_folders();
/// Where one of them has this module; else a path where there is no file.
std::string rtl_file(const std::string& module);

}  // namespace racebeam
