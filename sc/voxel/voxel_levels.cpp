// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_levels.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace racebeam {

namespace {

constexpr const char* Axes[] = {"x", "y", "z"};

/// Bit n to bit 3 n.
std::uint32_t part_1by2(std::uint32_t x) {
  x &= 0x3ff;
  x = (x ^ (x << 16)) & 0xff0000ff;
  x = (x ^ (x << 8)) & 0x0300f00f;
  x = (x ^ (x << 4)) & 0x030c30c3;
  return (x ^ (x << 2)) & 0x09249249;
}

int floor_log2(int value) {
  int bits = 0;
  while (value >> (bits + 1)) ++bits;
  return bits;
}

std::string text(int number) { return std::to_string(number); }

}  // namespace

std::uint32_t voxel_morton(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return part_1by2(z) << 2 | part_1by2(y) << 1 | part_1by2(x);
}

voxel_levels::voxel_levels(const vec3& size, const vec3& voxel, int levels) : size_(size) {
  vec3 sides{};
  for (int axis = 0; axis < 3; ++axis) {
    const int side = voxel[axis];
    if (side < 1 || side > VoxelMaxVoxel || (side & (side - 1)))
      throw std::invalid_argument("a voxel's side along " + std::string(Axes[axis]) + " is " +
                                  text(side) + "; 1, 2, 4, 8 or 16");
    if (size[axis] < side || size[axis] % side)
      throw std::invalid_argument("the world's side along " + std::string(Axes[axis]) + " is " +
                                  text(size[axis]) + ", no multiple of a voxel's " + text(side) +
                                  "; the next one is " +
                                  text((std::max(size[axis], 1) + side - 1) / side * side));
    voxel_bits_[axis] = floor_log2(side);
    sides[axis] = size[axis] / side;
  }
  count_ = std::min(
      {1 + floor_log2(*std::min_element(sides.begin(), sides.end())), levels, VoxelMaxLevels});
  const int largest = 1 << (count_ - 1);
  for (int axis = 0; axis < 3; ++axis) {
    if (sides[axis] % largest == 0) continue;
    const int step = largest * voxel[axis];
    throw std::invalid_argument(
        "the world's side along " + std::string(Axes[axis]) + " is " + text(size[axis]) +
        ", no multiple of " + text(step) + ", the side of the largest voxels; the next one is " +
        text((size[axis] + step - 1) / step * step) + ", or have fewer levels");
  }
  for (int k = 0; k < count_; ++k) {
    voxel_level& level = levels_[static_cast<std::size_t>(k)];
    level.offset = words_;
    std::uint32_t tiles = 1;
    for (int axis = 0; axis < 3; ++axis) {
      level.sides[axis] = sides[axis] >> k;
      level.tiles[axis] = (level.sides[axis] + VoxelTile - 1) / VoxelTile;
      tiles *= static_cast<std::uint32_t>(level.tiles[axis]);
    }
    words_ += tiles * VoxelTileWords;
  }
}

voxel_place voxel_levels::place(int k, int x, int y, int z) const {
  const voxel_level& at = level(k);
  voxel_place place;
  place.inside = z >= 0 && z < at.sides[2];
  x = voxel_wrapped(x, at.sides[0]);
  y = voxel_wrapped(y, at.sides[1]);
  z = voxel_wrapped(z, at.sides[2]);
  const int tile = (z / VoxelTile * at.tiles[1] + y / VoxelTile) * at.tiles[0] + x / VoxelTile;
  const std::uint32_t cell = voxel_morton(static_cast<std::uint32_t>(x % VoxelTile),
                                          static_cast<std::uint32_t>(y % VoxelTile),
                                          static_cast<std::uint32_t>(z % VoxelTile));
  place.word = at.offset + VoxelTileWords * static_cast<std::uint32_t>(tile) + (cell >> 5);
  place.bit = static_cast<int>(cell & 31);
  return place;
}

}  // namespace racebeam
