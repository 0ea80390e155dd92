// `racebeam knobs`: what may be changed with --set.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command.h"

namespace racebeam {

struct KnobsOptions {
  std::string engine;  ///< whose; empty: the first
  bool json = false;
};

/// Prints the knob table, as JSON if `json`. Returns the exit code. Throws UsageError.
int command_knobs(const KnobsOptions& options);

Command knobs_row();

}  // namespace racebeam
