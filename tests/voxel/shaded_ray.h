// Colours of pixels as the design has them, plainly; and pixels to try.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>

#include "sc/voxel/voxel_colour.h"

namespace racebeam {

/// Cells of the solid of a column that a ray ended at, from z on the way it goes.
inline std::pair<bool, std::set<int>> page_solid(const voxel_column& c, int z, bool down) {
  std::set<int> lower, upper;
  for (int at = 0; at < c.low; ++at) lower.insert(at);
  for (int at = c.middle; at < c.high; ++at) upper.insert(at);
  if (upper.empty() || lower.count(z)) return {false, lower};
  // Going down it ends at the highest one that is not above it; going up, at a roof from beneath.
  const bool takes_upper = down ? *upper.begin() <= z : *upper.begin() <= z + 1;
  return takes_upper ? std::pair{true, upper} : std::pair{false, lower};
}

inline int page_colour(const voxel_world& world, const voxel_palette& palette, const voxel_knobs& k,
                       const voxel_pixel& pixel) {
  const auto channels = [](const std::array<int, 3>& c) {
    return c[0] * 65536 + c[1] * 256 + c[2];
  };
  if (pixel.kind == VoxelSky) {
    int slope = 7;
    if (k.sky == VoxelSkyGradient) {
      slope = 0;
      while (slope < 15 && pixel.direction_z >= (slope + 1) * 4096) ++slope;
    }
    return channels({192 - 8 * slope, 226 - 6 * slope, 254 - 2 * slope});
  }
  if (k.debug_limits && pixel.kind == VoxelOuterLimit) return channels({255, 0, 255});
  if (k.debug_limits && pixel.kind == VoxelInnerLimit) return channels({127, 0, 127});
  const int x = pixel.position[0] >> 8, y = pixel.position[1] >> 8, z = pixel.position[2] >> 8;
  const voxel_column own = world.column(x, y);
  const auto [upper, solid] = page_solid(own, z, pixel.direction_z < 0);
  int height = 0;
  if (!solid.empty()) height = std::clamp(z, *solid.begin(), *solid.rbegin());
  const int material = upper ? own.high_material : own.low_material;
  int light = 16;
  if (k.shading == VoxelShadingSlope) {
    const auto h = [&, high = upper](int dx, int dy) {
      const voxel_column c = world.column(x + dx, y + dy);
      return high ? c.high : c.low;
    };
    light = 10 - 2 * (h(1, 0) - h(-1, 0)) - (h(0, 1) - h(0, -1));
    light = std::max(2, std::min(15, light));
  }
  const int entry = palette[static_cast<std::size_t>(material * 16 + height * 16 / k.size_z)];
  std::array<int, 3> c{entry / 65536, entry / 256 % 256, entry % 256};
  for (int& channel : c) channel = channel * light / 16 / (pixel.shadowed ? 2 : 1);
  return channels(c);
}

/// With caves and without, heights within the world.
inline voxel_column any_column(std::mt19937& random, int size_z) {
  const auto within = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  const int most = std::min(size_z, 255);
  std::array<int, 3> at{within(0, most), within(0, most), within(0, most)};
  std::sort(at.begin(), at.end());
  if (within(0, 1)) at[1] = at[2] = at[0];
  return {at[0], at[1], at[2], within(0, 7), within(0, 7)};
}

/// A way for a ray to end in a world: hits in the solid and at its borders, from above and beneath.
inline voxel_pixel any_pixel(std::mt19937& random, const voxel_world& world) {
  const auto within = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  voxel_pixel pixel;
  pixel.kind = static_cast<voxel_kind>(within(0, 3));
  const vec3& size = world.levels().size();
  const int x = within(-2 * size[0], 3 * size[0]), y = within(-2 * size[1], 3 * size[1]);
  const voxel_column c = world.column(x, y);
  const bool down = pixel.kind >= VoxelOuterLimit || within(0, 1);
  pixel.direction_z = down ? -within(1, 131072) : within(0, 131071);
  pixel.shadowed = pixel.kind == VoxelHit && within(0, 1);
  int z = within(-300, (size[2] + 20) * 256);
  if (within(0, 1))
    z = (within(0, 1) ? c.low : within(0, 1) ? c.middle : c.high) * 256 - within(0, 1);
  pixel.position = {x * 256 + within(0, 255), y * 256 + within(0, 255), z};
  return pixel;
}

}  // namespace racebeam
