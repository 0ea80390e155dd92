// Racing: which points of a sweep need no more frames.
//
// All points take the first 16 frames of the order, then 24, 32, 48, 64 ... and in the end the
// sample. After each rung, points that are surely dominated, or surely beyond a limit, stop and say
// so. Each look at a point of the front may take it for a dominated one with a chance of 5 %, by
// the bound for all its rivals; racing_test counts how often all looks of known sweeps together do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/sweep/front.h"

namespace racebeam {

constexpr int FirstRung = 16;

/// Frames that a point has after each rung: 16, 24, 32, 48 ... as long as a quarter of `sample` is
/// left, then `sample`. They lie evenly over the scene: halves, or halves and quarters by turns.
std::vector<int> rungs(int sample);

struct Stop {
  std::size_t point;  ///< among the candidates
  int by;             ///< the candidate that dominates it; -1: it is beyond a limit
  /// "dominated by p17 after 16 frames", "starved beyond its limit after 16 frames"
  std::string why;
};

/// The candidates that stop after a rung of so many frames, of those that go on; the base never
/// does.
std::vector<Stop> stops(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals,
                        int frames, double confidence);

}  // namespace racebeam
