// `racebeam units`: what --use, verify and trace call by its name, and what it costs as gates.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command.h"

namespace racebeam {

struct UnitsOptions {
  std::string engine;  ///< empty: the first one
  bool json = false;
  bool area = false;               ///< what they are as gates of osu018
  std::vector<std::string> units;  ///< of `area`; empty: all, and the whole chip
};

/// Prints the table of units, as JSON if `json`. Returns the exit code. Throws UsageError; of
/// `area` also RtlError, MissingTool, Interrupted.
int command_units(const UnitsOptions& options);

Command units_row();

}  // namespace racebeam
