// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_colour.h"

#include <algorithm>

#include "sc/base/probe.h"

namespace racebeam {

namespace {

constexpr int FullLight = 16, LeastLight = 2, MostLight = 15, FlatLight = 10;
constexpr int SkySteps = 15;     // below the zenith
constexpr int SkyFraction = 12;  // of a direction, cut
constexpr int ReadClocks = 2;    // of a column, beside the memory's own

constexpr int rgb(int red, int green, int blue) { return red << 16 | green << 8 | blue; }

}  // namespace

voxel_surface voxel_surface_of(const voxel_column& column, int z, bool down) {
  const bool below_low = z < column.low;
  const bool reaches_middle = (down ? z : z + 1) >= column.middle;
  const bool upper = !below_low && reaches_middle && column.middle < column.high;
  const int bottom = upper ? column.middle : 0;
  const int top = voxel_slope_height(column, upper);
  return {upper, std::max(bottom, std::min(z, top - 1))};
}

int voxel_palette_index(const voxel_column& column, const voxel_surface& surface, int size_z) {
  const int material = surface.upper ? column.high_material : column.low_material;
  const int height = rescaled(surface.height, count_bits(size_z), count_bits(VoxelPaletteHeights));
  return material * VoxelPaletteHeights + height % VoxelPaletteHeights;
}

int voxel_light_of(int slope) { return std::clamp(FlatLight - slope, LeastLight, MostLight); }

int voxel_lit(int colour, int sixteenths, bool shadowed) {
  const auto channel = [=](int shift) {
    return ((colour >> shift & 255) * sixteenths >> 4) >> shadowed;
  };
  return rgb(channel(16), channel(8), channel(0));
}

int voxel_sky_colour(int direction_z, const voxel_knobs& k) {
  const int slope = k.sky == VoxelSkyGradient ? std::clamp(direction_z >> SkyFraction, 0, SkySteps)
                                              : VoxelSkyMiddle;
  const int below = SkySteps - slope;
  return rgb(VoxelSkyRed + below * VoxelSkyRedStep, VoxelSkyGreen + below * VoxelSkyGreenStep,
             VoxelSkyBlue + below * VoxelSkyBlueStep);
}

voxel_shaded voxel_shade_pixel(const voxel_world& world, const voxel_palette& palette,
                               const voxel_knobs& k, const voxel_pixel& pixel) {
  if (pixel.kind == VoxelSky) return {voxel_sky_colour(pixel.direction_z, k), 0, 1};
  if (!voxel_shows_column(pixel.kind, k)) return {voxel_limit_colour(pixel.kind), 0, 1};
  const int x = pixel.position[0] >> VoxelPositionFraction;
  const int y = pixel.position[1] >> VoxelPositionFraction;
  const voxel_column column = world.column(x, y);
  const voxel_surface surface =
      voxel_surface_of(column, pixel.position[2] >> VoxelPositionFraction, pixel.direction_z < 0);
  int reads = voxel_reads_own(pixel.kind, k);
  int light = FullLight;
  if (k.shading == VoxelShadingSlope) {
    const auto height = [&](int east, int north) {
      return voxel_slope_height(world.column(x + east, y + north), surface.upper);
    };
    light = voxel_light_of(2 * (height(1, 0) - height(-1, 0)) + height(0, 1) - height(0, -1));
    reads += 4;
  }
  const int index = voxel_palette_index(column, surface, k.size_z);
  return {voxel_lit(palette[static_cast<std::size_t>(index)], light, pixel.shadowed), reads,
          1 + reads * (ReadClocks + k.memory_clocks)};
}

}  // namespace racebeam
