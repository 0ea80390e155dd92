// The sphere tracer's pictures beside those in double precision: a row of goldens().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/sphere_golden.h"
#include "tb/host/sphere_program.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// What the golden tracer is told of a picture.
SphereGoldenScene golden_scene(const SphereProgram& program, const sphere_knobs& k, int picture);

/// As GoldenKind has them. `scene`: a SphereProgram, or nullptr: the scene that is built in.
VgaFrame sphere_golden_picture(const scene_tables* scene, const knob_values& k, int picture);
PictureErrors sphere_golden_errors(const scene_tables* scene, const knob_values& k, int picture,
                                   const PackedPicture& chip, int step);
/// The same by what the golden tracer is told: `scene` is the golden_scene(), or another one.
PictureErrors sphere_errors(const SphereGoldenScene& scene, const SphereProgram& program,
                            const sphere_knobs& k, int picture, const PackedPicture& chip,
                            int step);

}  // namespace racebeam
