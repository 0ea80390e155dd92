// Mutants on recorded traffic, each to its first difference, on all cores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/signoff/mutant_fate.h"
#include "tb/signoff/unit_stimulus.h"

namespace racebeam {

/// Runs the mutants `numbers` of a plug-in that has MutantInput, each through the streams in order
/// until one of them finds it. A mutant that ends the RTL is found. `take` gets the fates, Found or
/// Alive, as they come. Throws RtlError, Interrupted, ChildDied.
void run_mutants(const std::string& plugin, const std::vector<int>& numbers,
                 const std::vector<RecordedStream>& streams, int jobs,
                 const std::function<void(const MutantFate&)>& take);

/// Where RTL without mutants differs from the model on the streams: stream, clock, port and values
/// as text; nothing if it does not. `plugin` may have MutantInput, which stays 0. Throws as
/// run_mutants().
std::optional<std::string> first_difference(const std::string& plugin,
                                            const std::vector<RecordedStream>& streams);

}  // namespace racebeam
