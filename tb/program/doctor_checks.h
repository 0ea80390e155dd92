// What `racebeam doctor` finds out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// "SystemC", "2.3.4".
struct Fact {
  std::string name, value;
};

/// Something that must work.
struct Check {
  std::string name;
  bool good;
  std::string detail;  ///< the error if not good
};

/// A program that other commands or the user may want.
struct OptionalTool {
  std::string name, package, use;
  std::string path;  ///< empty if not found
};

/// Versions of the program, its compiler and its libraries.
std::vector<Fact> versions();
/// Processor cores and memory.
std::vector<Fact> machine();
/// Writes a file of each kind to a temporary folder; looks for the RTL, and verilates a unit's if
/// there is a verilator.
std::vector<Check> check_files();
/// Looks for tools along PATH.
std::vector<OptionalTool> find_tools();

}  // namespace racebeam
