// The pictures that a sweep keeps of its points.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/sweep/measurer.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

/// Writes pictures/HASH.png of the frames that the file asks for, and pictures/index.csv, which
/// says what they show; those that are there stay. "worst": the frame with the most error pixels of
/// those that the point has. False: it was interrupted.
bool keep_pictures(const SweepPlan& plan, const SweepFolder& folder, Measurer& measurer,
                   const SweepState& state);

}  // namespace racebeam
