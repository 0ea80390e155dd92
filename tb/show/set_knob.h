// Knobs from the command line, and as text: "name=value".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Sets one knob from "name=value". Throws UsageError, which names the nearest knob, the engine
/// that has one of that name, or the range.
void set_knob(knob_values& k, const std::string& assignment);
void set_knob(knobs& k, const std::string& assignment);

/// Sets all of them, then those that others bound, which is told. Throws UsageError.
void set_knobs(const engine& built, knob_values& k, const std::vector<std::string>& assignments);

/// "default", or the assignments that make `k`; without those that the scene file sets.
std::string knobs_text(const knob_values& k);

}  // namespace racebeam
