// RTL that is to be verilated: which module, of which files, with what settings.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct RtlSources {
  std::string top = {};                           ///< module
  std::vector<std::string> files = {};            ///< in order
  std::vector<std::string> include_folders = {};  ///< beside those of the files themselves
  std::vector<std::string> defines = {};          ///< "NAME" or "NAME=VALUE"
  std::vector<std::string> parameters = {};       ///< "Name=value", a text as "Name=\"text\""
  /// Files or folders that are searched for modules that no file defines.
  std::vector<std::string> libraries = {};
  /// Unit: one of this project's chips, with its package and modules at hand. Chip: a whole chip of
  /// whomever, whose inputs but `clk` pass a register: they count one clock later.
  enum Kind { Unit, Chip } kind = Unit;
  bool signals = false;      ///< registers inside can be read
  bool marked_only = false;  ///< of signals those that the source marks, as Verilator has it
  /// "Name=value" of parameters that the files were made with and have no longer: gates.
  std::vector<std::string> made_with = {};
  /// At most 32 registers inside that can be written to, by names such as "u_stacks.sp_q"; for RTL
  /// that has nothing but rising edges. What it prints or asserts between edges is not heard then.
  std::vector<std::string> doors = {};
  bool coverage = false;  ///< it counts its lines, branches and toggling bits
};

}  // namespace racebeam
