// `racebeam verilate`: RTL of a unit as a plug-in in a file, for build systems.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command.h"

namespace racebeam {

struct VerilateOptions {
  std::string unit;
  std::vector<std::string> files;  ///< as after UNIT=; none: the unit's own RTL
  std::string plugin;              ///< to be written
  std::string dependencies;        ///< to be written, for make and ninja; empty: none
  std::vector<std::string> defines, parameters, include_folders, libraries;
  bool signals = false;
};

/// Writes the plug-in. Throws UsageError, RtlError, OutputError, MissingTool, Interrupted.
int command_verilate(const VerilateOptions& options);

Command verilate_row();

}  // namespace racebeam
