// Stored results measured again: the simulator is exact, so they must repeat bit for bit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/sweep/fork_server.h"
#include "tb/sweep/store.h"

namespace racebeam {

/// Measures `sample` frames of a model anew, taken at random from all that are stored; other ones
/// in each call. Adds what it found to the report; false if one differs. Those of another model
/// than this program's are not measured, and of scenes that are not there any more; it says so.
bool repeat_frames(Store& store, std::int64_t model, int sample, ForkServer& server, int jobs,
                   std::string& report);

}  // namespace racebeam
