// `racebeam knobs`: what may be changed with --set.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Prints the knob table, as JSON if `json`. Returns the exit code.
int command_knobs(bool json);

}  // namespace racebeam
