// `racebeam knobs`: what may be changed with --set.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

/// Prints the knob table, as JSON if `json`. Returns the exit code.
struct KnobsOptions {
  bool json = false;
};

int command_knobs(const KnobsOptions& options);

Command knobs_row();

}  // namespace racebeam
