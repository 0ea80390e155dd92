// Results of other sweeps that are equal by their keys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/store.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// Takes the frames that the folders of other sweeps have of points of which the store has nothing;
/// the number of them. Throws UsageError of a folder that is
/// none, and of results of another model.
std::int64_t reuse_results(Store& store, std::int64_t model, const SweepPlan& plan,
                           const std::vector<std::string>& folders);

}  // namespace racebeam
