// The world of the voxel tracer's vectors: 64 x 64 x 32, and a post.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/voxel/voxel_world.h"

namespace racebeam {

inline std::vector<std::uint32_t> tiny_columns() {
  std::vector<std::uint32_t> columns;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      voxel_column column;
      column.low = 4 + ((7 * x + 13 * y) & 7) + (x == 20 && y == 30 ? 16 : 0);
      column.middle = column.high = column.low;
      columns.push_back(packed(column));
    }
  return columns;
}

/// With voxels of 1 x `side_y` x 1.
inline voxel_world tiny_world(int side_y) {
  return {voxel_levels({64, 64, 32}, {1, side_y, 1}), tiny_columns()};
}

}  // namespace racebeam
