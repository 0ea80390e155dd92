// voxel_world: a height field with caves, and the occupancy octree beside it, as both memories hold
// them.
//
// A column of 1 x 1 unit is solid below `low` and from `middle` to `high`. x right, y away, z up;
// the world repeats along x and y for ever. A voxel is occupied if anything in it is solid.
//
// Source: article "Storage", "Preparation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sc/voxel/voxel_levels.h"

namespace racebeam {

/// A column, heights 0..255 with low <= middle <= high.
struct voxel_column {
  int low = 0, middle = 0, high = 0;
  int low_material = 0, high_material = 0;  ///< of what lies below `low`, and below `high`

  bool solid(int z) const { return z < low || (z >= middle && z < high); }
};

/// A word of column_memory: low in bits 7..0, middle in 15..8, high in 23..16, the materials in
/// 26..24 and 29..27.
constexpr std::uint32_t packed(const voxel_column& c) {
  return static_cast<std::uint32_t>(c.low | c.middle << 8 | c.high << 16 | c.low_material << 24 |
                                    c.high_material << 27);
}
constexpr voxel_column unpacked_column(std::uint32_t word) {
  return {static_cast<int>(word & 255), static_cast<int>(word >> 8 & 255),
          static_cast<int>(word >> 16 & 255), static_cast<int>(word >> 24 & 7),
          static_cast<int>(word >> 27 & 7)};
}

/// Columns with both limits: low <= x < high.
struct voxel_rectangle {
  int x_low = 0, y_low = 0, x_high = 0, y_high = 0;
};

class voxel_world {
 public:
  /// Columns of nothing; nothing is built.
  explicit voxel_world(const voxel_levels& levels);
  /// Word y * X + x is column (x, y); builds all. Throws std::invalid_argument if they are not as
  /// many as the world has.
  voxel_world(const voxel_levels& levels, std::vector<std::uint32_t> columns);

  const voxel_levels& levels() const { return levels_; }
  const std::vector<std::uint32_t>& columns() const { return columns_; }
  const std::vector<std::uint32_t>& occupancy() const { return occupancy_; }
  std::vector<std::uint32_t>& columns() { return columns_; }
  std::vector<std::uint32_t>& occupancy() { return occupancy_; }

  /// Where the word of a column is, in the world that repeats.
  std::uint32_t column_address(int x, int y) const;
  voxel_column column(int x, int y) const {
    return unpacked_column(columns_[column_address(x, y)]);
  }
  bool occupied(int level, int x, int y, int z) const {
    const voxel_place p = levels_.place(level, x, y, z);
    return p.inside && (occupancy_[p.word] >> p.bit & 1);
  }

  /// Occupancy of all levels from the columns: voxel_build(), without its clocks.
  void build();
  /// Occupied voxels of all levels.
  std::uint64_t bits_set() const;

 private:
  voxel_levels levels_;
  std::vector<std::uint32_t> columns_, occupancy_;
};

}  // namespace racebeam
