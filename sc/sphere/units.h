// The units of the sphere tracer, in one table: what takes a unit by its name asks here.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// In the order of the datapath, from the CPU and the switches to the screen; those of the frame
/// store and vga_timing, too. `scene` nullptr: start values and no planes.
const std::vector<unit_row>& sphere_unit_table();

}  // namespace racebeam
