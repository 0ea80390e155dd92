// The RTL that a unit of this project is made of, without a tool that reads SystemVerilog.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

namespace racebeam {

struct UnitSources {
  std::vector<std::string> files;    ///< paths: the unit, the package, what these name; sorted
  std::string key;                   ///< of the names and the contents of the files
  std::set<std::string> parameters;  ///< of the unit's module
};

/// Of the module in the file of that name in one of `folders`. A file there belongs to it if its
/// name, without extension, is a word of one that does. Throws MissingTool if there is none.
UnitSources unit_sources(const std::string& unit, const std::vector<std::string>& folders);

}  // namespace racebeam
