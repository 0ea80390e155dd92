// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_world.h"

#include <algorithm>
#include <bitset>
#include <stdexcept>
#include <string>
#include <utility>

namespace racebeam {

namespace {

using heights = std::bitset<VoxelMaxHeight>;

/// Voxels of `step` units in a column that have something solid.
void add(const voxel_column& c, int step, int top, heights& to) {
  const auto fill = [&](int from, int end) {
    for (int z = from / step; z < top && z * step < end; ++z) to.set(static_cast<std::size_t>(z));
  };
  fill(0, c.low);
  if (c.middle < c.high) fill(c.middle, c.high);
}

std::size_t columns_of(const voxel_levels& levels) {
  return static_cast<std::size_t>(levels.size()[0]) * static_cast<std::size_t>(levels.size()[1]);
}

}  // namespace

voxel_world::voxel_world(const voxel_levels& levels)
    : levels_(levels), columns_(columns_of(levels)), occupancy_(levels.words()) {}

voxel_world::voxel_world(const voxel_levels& levels, std::vector<std::uint32_t> columns)
    : levels_(levels), columns_(std::move(columns)), occupancy_(levels.words()) {
  if (columns_.size() != columns_of(levels))
    throw std::invalid_argument("a world of " + std::to_string(columns_of(levels)) +
                                " columns cannot have " + std::to_string(columns_.size()));
  build();
}

std::uint32_t voxel_world::column_address(int x, int y) const {
  const vec3& size = levels_.size();
  return static_cast<std::uint32_t>(voxel_wrapped(y, size[1])) *
             static_cast<std::uint32_t>(size[0]) +
         static_cast<std::uint32_t>(voxel_wrapped(x, size[0]));
}

void voxel_world::build() {
  std::fill(occupancy_.begin(), occupancy_.end(), 0);
  build_base();
  // The eight children of a voxel are a byte of the level below.
  for (int k = 1; k < levels_.count(); ++k) {
    const vec3& sides = levels_.level(k).sides;
    for (int z = 0; z < sides[2]; ++z)
      for (int y = 0; y < sides[1]; ++y)
        for (int x = 0; x < sides[0]; ++x) {
          const voxel_place child = levels_.place(k - 1, 2 * x, 2 * y, 2 * z);
          if (!(occupancy_[child.word] >> child.bit & 255)) continue;
          const voxel_place own = levels_.place(k, x, y, z);
          occupancy_[own.word] |= 1u << own.bit;
        }
  }
}

void voxel_world::build_base() {
  const vec3& sides = levels_.level(0).sides;
  const int side_x = levels_.side(0, 0), side_y = levels_.side(0, 1), side_z = levels_.side(0, 2);
  for (int y = 0; y < sides[1]; ++y)
    for (int x = 0; x < sides[0]; ++x) {
      heights solid;
      for (int j = 0; j < side_y; ++j)
        for (int i = 0; i < side_x; ++i)
          add(column(x * side_x + i, y * side_y + j), side_z, sides[2], solid);
      for (int z = 0; z < sides[2]; ++z) {
        if (!solid[static_cast<std::size_t>(z)]) continue;
        const voxel_place p = levels_.place(0, x, y, z);
        occupancy_[p.word] |= 1u << p.bit;
      }
    }
}

std::uint64_t voxel_world::bits_set() const {
  std::uint64_t count = 0;
  for (const std::uint32_t word : occupancy_)
    count += static_cast<unsigned>(__builtin_popcount(word));
  return count;
}

}  // namespace racebeam
