// Random worlds and rays through them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "sc/voxel/voxel_rays.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

inline int within(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution(low, high)(random);
}

inline voxel_knobs any_knobs(std::mt19937& random) {
  voxel_knobs k;
  k.size_x = within(random, 1, 3) * 32;
  k.size_y = within(random, 1, 3) * 64;
  k.size_z = 32;
  k.voxel_x = 1 << within(random, 0, 1);
  k.voxel_y = 1 << within(random, 0, 2);
  k.voxel_z = 1;
  k.levels = within(random, 1, 4);
  k.leaf_steps = within(random, 1, 8);
  k.raise = within(random, 0, 1);
  k.group_fetch = within(random, 0, 1);
  k.memory_clocks = within(random, 1, 4);
  if (k.voxel_x * k.voxel_y == 1) k.leaf = within(random, 0, 1);
  return k;
}

/// Hills with caves, of any height.
inline std::vector<std::uint32_t> rough_columns(std::mt19937& random, const voxel_knobs& k) {
  std::vector<std::uint32_t> columns;
  for (int n = 0; n < k.size_x * k.size_y; ++n) {
    voxel_column c;
    c.low = within(random, 0, k.size_z / 3);
    c.middle = c.low + within(random, 0, k.size_z / 3);
    c.high = n % 5 ? c.middle : c.middle + within(random, 0, k.size_z / 3 - 1);
    columns.push_back(packed(c));
  }
  return columns;
}

inline voxel_ray any_ray(std::mt19937& random, const voxel_knobs& k) {
  voxel_ray ray;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = within(random, -k.size()[axis] * 128, k.size()[axis] * 384);
    ray.direction[axis] = within(random, -65536, 65536) >> within(random, 0, 14);
  }
  return ray;
}

}  // namespace racebeam
