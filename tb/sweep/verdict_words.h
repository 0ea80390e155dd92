// What is said of the points of a sweep, in words.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/sweep/figures.h"
#include "tb/sweep/front.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

const char* standing_word(Verdict::Standing standing);

/// Goals first, then what says at what price: of tables.
std::vector<const PointFigure*> shown_figures(const SweepFile& file);

/// "p8 has less picture_error than chip by 0.079 points +/- 0.026 (95 % for the best of 7)", with a
/// newline: the point of the front that changes the first sampled goal the most for the better,
/// against the base, which is the first candidate. `points`: of the sweep, for the interval. "":
/// there is none.
std::string best_words(const SweepFile& file, const std::vector<Candidate>& candidates,
                       const std::vector<Verdict>& verdicts, int points);

/// "8 on the front, 0 undecided, 0 dominated, 0 unwanted, 0 failed", with a newline.
std::string counts_words(const SweepFile& file, const std::vector<Verdict>& verdicts, int failed);

/// "8 points +/- 0.2: not surely": by how much, of the figure's unit, without its sign.
std::string change_words(const PointFigure& figure, Estimate change);

}  // namespace racebeam
