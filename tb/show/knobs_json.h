// Knobs as JSON, for the statistics, the manifest and `racebeam knobs --json`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sc/beam/knobs.h"

namespace racebeam {

/// {"interval_stack_depth": 4, "bisection": "pow2", ...}: numbers, or names where values have
/// names. Without those that the scene file sets: the scene has them.
nlohmann::ordered_json knobs_json(const knobs& k);

/// One value, as in knobs_json().
nlohmann::ordered_json knob_json(const knob_info& row, int value);

}  // namespace racebeam
