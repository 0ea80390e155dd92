// Where the project's own files are: RTL, scenes, what plug-ins are compiled with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// The folder with rtl/ and sc/: of the sources, or where they are installed.
std::string project_folder();

/// The folder of this project's RTL.
std::string rtl_folder();

}  // namespace racebeam
