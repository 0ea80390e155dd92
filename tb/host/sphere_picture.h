// A picture of a scene of spheres before it is drawn, without those before it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "sc/sphere/sphere_core.h"
#include "tb/host/sphere_program.h"

namespace racebeam {

/// What the CPU sends for a picture.
std::vector<sphere_row> spheres_of(const SphereProgram& program, const sphere_knobs& k,
                                   int picture);

/// The tracer with the table, eye, light and modes of a picture, before its first pixel. The
/// program outlives it.
std::unique_ptr<sphere_core> core_before(const SphereProgram& program, const sphere_knobs& k,
                                         int picture);

}  // namespace racebeam
