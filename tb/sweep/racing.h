// Racing: which points of a sweep need no more frames.
//
// All points take the first 16 frames of the order, then 32, 64 ... and in the end the sample.
// After each rung, points that are surely dominated, or surely beyond a limit, stop and say so.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/sweep/front.h"

namespace racebeam {

constexpr int FirstRung = 16;

/// Frames that a point has after each rung: 16, 32, ... below `sample`, then `sample`.
std::vector<int> rungs(int sample);

struct Stop {
  std::size_t point;  ///< among the candidates
  int by;             ///< the candidate that dominates it; -1: it is beyond a limit
  /// "dominated by p17 after 16 frames", "starved beyond its limit after 16 frames"
  std::string why;
};

/// The candidates that stop after a rung of so many frames; the base never does.
std::vector<Stop> stops(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals,
                        int frames, double confidence);

}  // namespace racebeam
