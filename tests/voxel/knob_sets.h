// Worlds and rules that tests of the voxel tracer's RTL share, so that each is verilated once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/knobs.h"

namespace racebeam {

inline voxel_knobs voxel_world_of(const vec3& size, const vec3& voxel, int levels,
                                  int memory_clocks) {
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.levels = levels;
  k.memory_clocks = memory_clocks;
  return k;
}

/// In groups: eight children are fetched at once. Up: as far as a border is a larger voxel's too.
struct voxel_rules {
  int leaf_steps = 1;
  bool hit_voxels = false, in_groups = false, all_up = false;
};
inline voxel_knobs with(voxel_knobs k, const voxel_rules& rules) {
  k.leaf = rules.hit_voxels ? VoxelLeafVoxel : VoxelLeafMarch;
  k.leaf_steps = rules.leaf_steps;
  k.raise = rules.all_up ? VoxelRaiseAll : VoxelRaiseOne;
  k.group_fetch = rules.in_groups;
  return k;
}

inline voxel_knobs tiny_set() { return {}; }
inline voxel_knobs cubes_set() {
  return with(voxel_world_of({64, 64, 32}, {1, 1, 1}, 9, 2), {1, true, true, true});
}
inline voxel_knobs odd_set() {
  return with(voxel_world_of({96, 160, 64}, {2, 4, 1}, 4, 3), {3, false, true, false});
}
inline voxel_knobs coarse_set() {
  return with(voxel_world_of({64, 64, 64}, {4, 4, 4}, 9, 1), {8, false, true, true});
}
inline voxel_knobs one_level_set() {
  return with(voxel_world_of({48, 80, 16}, {1, 2, 1}, 1, 1), {7, false, false, false});
}
inline voxel_knobs large_set() {
  return with(voxel_world_of({2048, 16384, 256}, {16, 8, 1}, 9, 8), {5, false, false, true});
}

}  // namespace racebeam
