// The sphere tracer's knobs and start values as the RTL of its units knows them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"
#include "sc/swap/rtl_parameters.h"

namespace racebeam {

/// One for each knob, root_bits_per_clock is RootBitsPerClock; and those of the frame store.
std::vector<rtl_parameter> sphere_knob_parameters(const sphere_knobs& k);

/// The same; OriginX to Screen; and Planes, the number of planes.
std::vector<rtl_parameter> sphere_parameters(const sphere_knobs& k, const sphere_tables& tables);

/// A plane as plane_table's RTL reads it: a row of PlaneFile, 44 digits.
std::string plane_file_row(const plane_row& plane);

}  // namespace racebeam
