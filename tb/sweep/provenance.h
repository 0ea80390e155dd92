// Where the results of a sweep come from: the model, the program, the machine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/sweep/store.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// The id of this program's model in a store. Throws UsageError if the store has results of another
/// one only, unless `fresh`.
std::int64_t open_model(Store& store, const SweepPlan& plan, const std::string& folder, bool fresh);

/// Whether this very program has not been seen to count as the store's results say.
bool is_new_program(const Store& store, std::int64_t model);
/// It has.
void know_program(Store& store, std::int64_t model);

/// This run for the store.
SweepRun this_run(const std::string& command, int cores);
/// Of this process and its workers so far.
double cpu_seconds();

}  // namespace racebeam
