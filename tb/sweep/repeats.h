// Whether another program with the same model counts as a store says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/sweep/measurer.h"

namespace racebeam {

/// Repeats three stored frames, if this program has not yet done so. False: it was interrupted.
/// Throws NotDeterministic if one differs.
bool repeats_as_stored(const SweepPlan& plan, Store& store, std::int64_t model, Measurer& measurer);

}  // namespace racebeam
