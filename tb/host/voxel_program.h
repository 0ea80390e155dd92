// VoxelProgram: what the voxel tracer and the host beside it have of a scene file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sc/voxel/voxel_tables.h"

namespace racebeam {

/// A hole in the ground, made before a picture.
struct VoxelCrater {
  int picture = 0;
  int x = 0, y = 0;  ///< its middle, in columns
  int radius = 1, depth = 1;
};

/// Its own columns are those before picture 0.
struct VoxelProgram : voxel_tables {
  std::vector<voxel_view> views;  ///< of each picture; after the last, again from the first
  std::vector<VoxelCrater> craters;

  /// What the two solids of each column belong to, as numbers: the lower one and the upper one by
  /// turns; empty: each to itself.
  std::vector<int> objects;

  int object(std::uint32_t column, bool upper) const {
    const std::size_t at = 2 * std::size_t{column} + upper;
    return objects.empty() ? static_cast<int>(at) : objects[at];
  }
  const voxel_view& view(int picture) const {
    return views[static_cast<std::size_t>(picture) % views.size()];
  }
};

/// The scene that is built in: the world and the picture of the vectors, `tiny`.
const VoxelProgram& builtin_voxel_program();

/// `scene` is a VoxelProgram, or nullptr: the built-in one.
const VoxelProgram& voxel_program_of(const scene_tables* scene);

}  // namespace racebeam
