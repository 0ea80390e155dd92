// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_craters.h"

#include <algorithm>
#include <utility>

namespace racebeam {

namespace {

/// Columns from `low` to `high`, of a world of `side` that repeats: one part, or two.
std::vector<std::pair<int, int>> parts(int low, int high, int side) {
  if (high - low >= side) return {{0, side}};
  const int from = voxel_wrapped(low, side), end = from + high - low;
  if (end <= side) return {{from, end}};
  return {{from, side}, {0, end - side}};
}

voxel_column dug_off(voxel_column c, int depth) {
  const int upper = std::min(depth, c.high - c.middle);
  c.high -= upper;
  c.low = std::max(c.low - (depth - upper), 0);
  if (c.high == c.middle) c.middle = c.high = c.low;
  return c;
}

}  // namespace

int dug(const VoxelCrater& crater, int x, int y) {
  const int square = crater.radius * crater.radius, off = square - x * x - y * y;
  return off > 0 ? static_cast<int>(std::int64_t{crater.depth} * off / square) : 0;
}

std::vector<voxel_rectangle> make_crater(const VoxelCrater& crater, const vec3& size,
                                         std::vector<std::uint32_t>& columns) {
  const int r = crater.radius;
  for (int y = 1 - r; y < r; ++y)
    for (int x = 1 - r; x < r; ++x) {
      std::uint32_t& word = columns[static_cast<std::size_t>(voxel_wrapped(crater.y + y, size[1])) *
                                        static_cast<std::size_t>(size[0]) +
                                    static_cast<std::size_t>(voxel_wrapped(crater.x + x, size[0]))];
      if (const int depth = dug(crater, x, y)) word = packed(dug_off(unpacked_column(word), depth));
    }
  std::vector<voxel_rectangle> changed;
  for (const auto& [y_low, y_high] : parts(crater.y + 1 - r, crater.y + r, size[1]))
    for (const auto& [x_low, x_high] : parts(crater.x + 1 - r, crater.x + r, size[0]))
      changed.push_back({x_low, y_low, x_high, y_high});
  return changed;
}

}  // namespace racebeam
