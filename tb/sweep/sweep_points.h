// The points of a sweep: the base, the named ones, and those that the search asks for.
//
// grid        all combinations; the knob that the file names first changes slowest
// one-by-one  each value of each knob, in the order of the file, the others as in the base
// sobol       Sobol's sequence over the knobs of the file, a dimension each; a number in 0..1
//             becomes the k-th value of the knob's list. The seed shifts it digit by digit.
// nsga2       begins with points of Sobol's sequence; what it asks for then depends on their goals
//
// The search calls its points p1, p2 ... in the order in which it asks for them. What it asks for
// again is there once; what is the base or a named point has that name, and its number is left out.
// So more points of sobol, or another named point, change no name.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/sweep/sweep_file.h"
#include "tb/sweep/sweep_point.h"
#include "tb/sweep/value_indices.h"

namespace racebeam {

struct SweepPoints {
  std::vector<SweepPoint> points;  ///< the base first, then the named ones, then p1, p2 ...
  int of_search = 0;               ///< different ones that the search asks for
  int refused = 0;                 ///< by `where`, each time that the search asks
  int again = 0;                   ///< asked for again
  /// Named points that are another by name: "no limits", "chip".
  std::vector<std::pair<std::string, std::string>> same{};
  /// Of Sobol's sequence and nsga2: what was asked for, and which of `points` that is; -1: `where`
  /// refuses it. What Sobol asks for in vain or again is not here.
  std::vector<std::pair<ValueIndices, int>> asked{};
};

/// Combinations of a grid, before `where`.
double grid_points(const SweepFile& file);

/// The points of a file without faults. Two are the same if they are so on each scene:
/// `standards` are their Show::standard_knobs(). Sobol's sequence ends early if 10,000 of it in a
/// row bring no new point. `more`: what nsga2 asks for after its first generation.
SweepPoints sweep_points(const SweepFile& file, const std::vector<knob_values>& standards,
                         const std::vector<ValueIndices>& more = {});

/// On what its engine has built in.
SweepPoints sweep_points(const SweepFile& file);

}  // namespace racebeam
