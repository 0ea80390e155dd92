// VoxelChunks: what is to be built, cut so that a frame of the raster has no more than a chunk.
//
// Source: article "Preparation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/voxel/voxel_levels.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

/// Rectangles by frame: each has columns of a chunk at most, or is one column wide and high; a
/// larger one is cut into four. A frame has 10 at most, and their columns fit into a chunk.
std::vector<std::vector<voxel_rectangle>> voxel_chunks(std::vector<voxel_rectangle> rectangles,
                                                       int build_chunk);

}  // namespace racebeam
