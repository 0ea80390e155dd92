// The first difference of a unit in lockstep in words: the clocks around it, and what they prove.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/twin/lockstep.h"

namespace racebeam {

/// Stands before each value of the RTL that is not the model's, in a table without colours.
constexpr char DifferenceMark = '>';

/// A row for each input, for each output whose sides agree in all clocks shown, and for each side
/// of the others. Columns are clocks, 0 that of the difference; equal ones in a row are one column,
/// so that the table reaches further back.
std::string difference_table(const LockstepDifference& difference);

/// A line for each thing that is true of all clocks of the window: that a side is late, inverted,
/// stuck, that only one bit differs, how long it lasts, how long ago the reset was. Each says what
/// it was seen in.
std::string difference_hints(const LockstepDifference& difference);

/// The values after a mark in red, for a terminal.
std::string in_colour(const std::string& text);

}  // namespace racebeam
