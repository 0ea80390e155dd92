// Knobs from the command line, and as text: "name=value".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/beam/knobs.h"

namespace racebeam {

/// Sets one knob from "name=value". Throws UsageError, which names the nearest knob or the range.
void set_knob(knobs& k, const std::string& assignment);

/// Sets all of them. max_room_depth gets the value that counts, and it is told if that is less.
/// Throws UsageError.
void set_knobs(knobs& k, const std::vector<std::string>& assignments);

/// "default", or the assignments that make `k`; without those that the scene file sets.
std::string knobs_text(const knobs& k);

}  // namespace racebeam
