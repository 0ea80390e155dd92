// The voxel tracer's knobs as the RTL of its units knows them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/swap/rtl_parameters.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

/// Throws std::invalid_argument if the world's sides do not go with its voxels.
std::vector<rtl_parameter> voxel_parameters(const voxel_knobs& k);

}  // namespace racebeam
