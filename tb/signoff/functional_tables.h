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
std::vector<FunctionalCross> sphere_crosses();
std::vector<FunctionalCross> block_crosses();
std::vector<FunctionalCross> voxel_crosses();
std::vector<FunctionalCross> store_crosses();  ///< of the frame store, which several have

}  // namespace racebeam
