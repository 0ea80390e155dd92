// Figures with their intervals as words: as many digits as the interval supports, and no figure
// without its interval or the words that all frames were taken.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/sweep/interval.h"

namespace racebeam {

/// "11,135"
std::string grouped(long long number);
/// A figure known exactly, such as cells: "6,867 cells", "0.4273 %".
std::string text_of(double exact, const std::string& unit = "");
/// "3.15 % +/- 0.25", "3.147 % (all 11,135 frames)", "3.1 % (too few frames)", or
/// "0 % (alike in 256 frames)" if the frames taken do not differ; "not measured" without frames.
std::string text_of(const Estimate& estimate, const std::string& unit = "");
/// "1,534 clocks (worst of 320 frames)", "... (worst of all 11,135 frames)"
std::string text_of(const Worst& worst, const std::string& unit = "");
/// "37 % of frames, 31 to 43 % (95 %)", "fewer than 1.4 % of frames (95 %)" if there is none,
/// "37.21 % of all 11,135 frames".
std::string text_of(const Share& share, double confidence = Confidence);

}  // namespace racebeam
