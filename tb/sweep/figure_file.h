// All figures of all points of a sweep as CSV, each with its interval and its change.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/sweep/measurer.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

/// All figures that a sweep may have, in the order of their table.
std::vector<const PointFigure*> sweep_figures(const SweepFile& file);

/// One row a point, scene and figure that was measured: frames of which it is, the value, half of
/// its interval of 95 %, the change against the base on the same frames, and half of that one's. A
/// cell is empty where there is no such number: a design's cells have no interval. With several
/// scenes rows of scene "all" have the means over them. From the first `frames` of a point.
std::string figures_csv(const SweepPlan& plan, const Measurer& measurer, const SweepState& state,
                        int frames);

}  // namespace racebeam
