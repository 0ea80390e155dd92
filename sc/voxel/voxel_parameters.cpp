// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_parameters.h"

#include "sc/store/store_parameters.h"
#include "sc/voxel/voxel_levels.h"

namespace racebeam {

std::vector<rtl_parameter> voxel_parameters(const voxel_knobs& k) {
  std::vector<rtl_parameter> all = store_parameters(k.store());
  const std::vector<rtl_parameter> own = {
      {"SizeX", k.size_x, "the world's side along x"},
      {"SizeY", k.size_y, "the world's side along y"},
      {"SizeZ", k.size_z, "the world's side along z"},
      {"VoxelX", k.voxel_x, "the smallest voxel's side along x"},
      {"VoxelY", k.voxel_y, "the smallest voxel's side along y"},
      {"VoxelZ", k.voxel_z, "the smallest voxel's side along z"},
      {"Levels", voxel_levels(k).count(), "the levels of the octree"},
      {"MaxOuter", k.max_outer, "the knob max_outer"},
      {"MaxInner", k.max_inner, "the knob max_inner"},
      {"Leaf", k.leaf, "the knob leaf"},
      {"LeafSteps", k.leaf_steps, "the knob leaf_steps"},
      {"Raise", k.raise, "the knob raise"},
      {"GroupFetch", k.group_fetch, "the knob group_fetch"},
      {"Shading", k.shading, "the knob shading"},
      {"Sky", k.sky, "the knob sky"},
      {"Shadows", k.shadows, "the knob shadows"},
      {"ShadowOuter", k.shadow_outer, "the knob shadow_outer"},
      {"ShadowInner", k.shadow_inner, "the knob shadow_inner"},
      {"DebugLimits", k.debug_limits, "the knob debug_limits"},
      {"BuildChunk", k.build_chunk, "the knob build_chunk"},
      {"MemoryClocks", k.memory_clocks, "the knob memory_clocks"}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace racebeam
