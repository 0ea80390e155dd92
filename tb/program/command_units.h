// `racebeam units`: what --use, verify and trace call by its name.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command.h"

namespace racebeam {

struct UnitsOptions {
  std::string engine;  ///< empty: the first one
  bool json = false;
};

/// Prints the table of units, as JSON if `json`. Returns the exit code.
int command_units(const UnitsOptions& options);

Command units_row();

}  // namespace racebeam
