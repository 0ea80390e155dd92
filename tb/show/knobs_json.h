// Knobs as JSON, for the statistics, the manifest and `racebeam knobs --json`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sc/base/knob_values.h"

namespace racebeam {

/// {"interval_stack_depth": 4, "bisection": "pow2", ...}: numbers, or names where values have
/// names. Without those that the scene file sets: the scene has them.
nlohmann::ordered_json knobs_json(const knob_values& k);

/// One value, as in knobs_json().
nlohmann::ordered_json knob_json(const knob_row& row, int value);

}  // namespace racebeam
