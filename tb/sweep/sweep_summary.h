// What a sweep is going to do, and what it has found, in words.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/sweep/measurer.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

/// "stack against queue: 86 points of 4 knobs; demo, 256 of 11,135 frames (1,664 left out) + 64
/// guard frames". `there`: frames that need not be measured.
std::string plan_text(const SweepPlan& plan, int there);

/// The points on the front and the base with their figures, each with its interval, from so many
/// frames of a point; the surest statement about the best of them; counts; points that failed.
std::string summary_text(const SweepPlan& plan, const Measurer& measurer, const SweepState& state,
                         int frames);

/// What differs from the base: "fifo_entries=12 hurry_threshold=64".
std::string setting_words(const SweepPlan& plan, int point);

}  // namespace racebeam
