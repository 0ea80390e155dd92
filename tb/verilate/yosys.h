// yosys, as the scripts of this project call it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// The script that has the recipe, or another one. Throws MissingTool.
std::string recipe_file(const std::string& script = "netlist");

/// "Yosys 0.23 (git sha1 7ce5011c24b)". Throws MissingTool if it is not there or does not answer;
/// Interrupted.
std::string yosys_version();

/// The file of osu018's standard cells. Throws MissingTool, with the package to install.
std::string osu018_cells();

}  // namespace racebeam
