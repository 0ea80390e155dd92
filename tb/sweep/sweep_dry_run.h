// What a sweep would cost.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/sweep/fork_server.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// Points, frames, and an estimate of time and disk from three timed frames of the base; looks at
/// what a folder has already, and writes nothing.
std::string dry_run_text(const SweepPlan& plan, const std::string& folder, ForkServer& server,
                         int jobs);

}  // namespace racebeam
