// The units of the voxel tracer, in one table: what takes a unit by its name asks here.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// In the order of the datapath, from the host to the screen; those of the frame store and
/// vga_timing, too.
const std::vector<unit_row>& voxel_unit_table();

}  // namespace racebeam
