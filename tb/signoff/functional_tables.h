// The crosses of all units, by engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/signoff/functional_points.h"

namespace racebeam {

std::vector<FunctionalCross> beam_tracer_crosses();  ///< from the camera to the interval
std::vector<FunctionalCross> beam_other_crosses();   ///< from the interval to the pins
std::vector<FunctionalCross> other_crosses();        ///< of the sphere, block and voxel engines

}  // namespace racebeam
