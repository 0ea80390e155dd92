// The levels of an occupancy octree: how many there are, their sides in voxels, and where their
// bits lie in the memory.
//
// A level has half the sides of the one below it. It is cut into tiles of 8 x 8 x 8 voxels, a bit
// each in Morton order, x lowest: 16 words of 32 bits. Tiles follow each other along x, then y,
// then z; levels from the finest on.
//
// Source: article "Storage", "Fetch code".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

struct voxel_level {
  vec3 sides{};              ///< in voxels of this level
  vec3 tiles{};              ///< along each axis
  std::uint32_t offset = 0;  ///< its first word
};

/// Where the bit of a voxel is.
struct voxel_place {
  std::uint32_t word = 0;
  int bit = 0;
  bool inside = true;  ///< not below or above the world, where nothing is
};

/// Morton order: bit n of x, y and z to bits 3 n, 3 n + 1 and 3 n + 2; ten bits of each.
std::uint32_t voxel_morton(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// The rest of a division by `size` that is not negative: a place in a world that repeats.
constexpr int voxel_wrapped(int value, int size) {
  const int rest = value % size;
  return rest < 0 ? rest + size : rest;
}

class voxel_levels {
 public:
  /// `levels`: at most so many. Throws std::invalid_argument with what is wrong and what to do, if
  /// a side is no multiple of the largest voxel's.
  voxel_levels(const vec3& size, const vec3& voxel, int levels = VoxelMaxLevels);
  explicit voxel_levels(const voxel_knobs& k) : voxel_levels(k.size(), k.voxel(), k.levels) {}

  int count() const { return count_; }
  const voxel_level& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }
  /// Words of all levels.
  std::uint32_t words() const { return words_; }
  /// The base voxel's sides are 2 to the power of these.
  const vec3& voxel_bits() const { return voxel_bits_; }
  const vec3& size() const { return size_; }
  /// The side of a voxel of a level along an axis, in units.
  int side(int k, int axis) const { return 1 << (voxel_bits_[axis] + k); }

  /// The world repeats along x and y, for negative coordinates too.
  voxel_place place(int k, int x, int y, int z) const;

 private:
  vec3 size_, voxel_bits_{};
  int count_ = 0;
  std::array<voxel_level, VoxelMaxLevels> levels_{};
  std::uint32_t words_ = 0;
};

}  // namespace racebeam
