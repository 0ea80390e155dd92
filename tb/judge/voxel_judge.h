// The voxel tracer's pictures beside those in double precision: a row of goldens().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/host/voxel_show.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// What the rays of all pixels meet, row by row: an object of the program, or HitMap::Nothing.
/// `show` is at the picture.
std::vector<int> voxel_first_hits(const VoxelShow& show, const voxel_knobs& k);
std::vector<int> voxel_golden_hits(const VoxelShow& show, const voxel_knobs& k);

/// As GoldenKind has them. `scene`: a VoxelProgram, or nullptr: the scene that is built in. A hit
/// is wrong if its column is more than one away.
VgaFrame voxel_golden_picture(const scene_tables* scene, const knob_values& k, int picture);
PictureErrors voxel_golden_errors(const scene_tables* scene, const knob_values& k, int picture,
                                  const PackedPicture& chip, int step);

}  // namespace racebeam
