// The cores that draw a picture give the closed forms' colours in as many clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "tests/voxel/picture_rig.h"
#include "tests/voxel/tiny_world.h"

namespace racebeam {
namespace {

constexpr vec3 Light{14301, 28602, 57205};  // (1, 2, 4), normalised

/// The page's picture of the world tiny.
PictureView tiny_view() {
  return {{32 * 256 + 128, 2 * 256 + 64, 40 * 256},
          {-6710880, 10066330, -838866},
          {209715, 0, 0},
          {0, 0, -209715},
          Light};
}

voxel_knobs tiny_knobs() {
  voxel_knobs k;
  k.picture_width = 64;
  k.picture_height = 48;
  return k;
}

voxel_palette any_palette() {
  std::mt19937 random(3);
  voxel_palette palette{};
  for (int& colour : palette) colour = static_cast<int>(random() & 0xffffff);
  return palette;
}

/// The world tiny, with materials and a roof over a part of it.
std::vector<std::uint32_t> roofed_columns() {
  std::vector<std::uint32_t> columns = tiny_columns();
  for (std::size_t n = 0; n < columns.size(); ++n) {
    voxel_column c = unpacked_column(columns[n]);
    c.low_material = static_cast<int>(n / 5 % 8);
    c.high_material = static_cast<int>(n / 7 % 8);
    if (n / 64 % 16 < 4 && n % 64 % 16 < 12) {
      c.middle = 24;
      c.high = 27 + static_cast<int>(n % 3);
    }
    columns[n] = packed(c);
  }
  return columns;
}

/// The same, of closed forms.
DrawnPicture in_closed_form(const voxel_world& world, const voxel_knobs& k,
                            const voxel_palette& palette, const PictureView& view,
                            std::array<int, 4>& kinds, int& shadows) {
  DrawnPicture picture;
  for (int y = 0; y < k.picture_height; ++y)
    for (int x = 0; x < k.picture_width; ++x) {
      voxel_ray ray{view.origin, {}};
      for (std::size_t n = 0; n < 3; ++n)
        ray.direction[n] = (view.d00[n] + x * view.dx[n] + y * view.dy[n]) >> 8;
      voxel_walked walked;
      const voxel_end end = voxel_walk(world, k, ray, {k.max_outer, k.max_inner}, walked);
      voxel_pixel pixel{end.kind, end.position, ray.direction[2], false};
      ++kinds[end.kind];
      if (k.shadows && end.kind == VoxelHit) {
        vec3 from{};  // 1.5 units towards the light
        for (std::size_t n = 0; n < 3; ++n) from[n] = end.position[n] + (3 * view.light[n] >> 9);
        const voxel_end met =
            voxel_walk(world, k, {from, view.light}, {k.shadow_outer, k.shadow_inner}, walked);
        pixel.shadowed = met.kind == VoxelHit;
        shadows += pixel.shadowed;
      }
      const voxel_shaded shaded = voxel_shade_pixel(world, palette, k, pixel);
      picture.colours[y << 10 | x] = shaded.colour;
      picture.clocks += walked.clocks + static_cast<unsigned>(shaded.clocks);
      picture.column_reads += walked.column_reads + static_cast<unsigned>(shaded.reads);
    }
  return picture;
}

bool always() { return true; }

/// The kinds that were met, and how many shadows.
std::pair<std::array<int, 4>, int> expect_closed_form(const voxel_knobs& k,
                                                      const PictureView& view) {
  const voxel_world world(voxel_levels(k), roofed_columns());
  const voxel_palette palette = any_palette();
  std::array<int, 4> kinds{};
  int shadows = 0;
  const DrawnPicture expected = in_closed_form(world, k, palette, view, kinds, shadows);
  const DrawnPicture drawn = PictureRig(world, k, palette).draw(view, always);
  EXPECT_EQ(drawn.clocks, expected.clocks);
  EXPECT_EQ(drawn.column_reads, expected.column_reads);
  EXPECT_EQ(drawn.colours, expected.colours);
  return {kinds, shadows};
}

TEST(VoxelPicture, TinyTakesAClockAPixelMoreThanItsRays) {
  const DrawnPicture drawn =
      PictureRig(tiny_world(4), tiny_knobs(), any_palette()).draw(tiny_view(), always);
  EXPECT_EQ(drawn.clocks, 312737u + 64 * 48);
  EXPECT_EQ(drawn.colours.size(), 64u * 48);
}

TEST(VoxelPicture, SlopeTakesThirteenClocksAPixel) {
  voxel_knobs k = tiny_knobs();
  k.shading = VoxelShadingSlope;
  const DrawnPicture drawn = PictureRig(tiny_world(4), k, any_palette()).draw(tiny_view(), always);
  EXPECT_EQ(drawn.clocks, 312737u + 64 * 48 * 13);
}

TEST(VoxelPicture, IsThatOfTheClosedFormsByHeight) {
  const auto [kinds, shadows] = expect_closed_form(tiny_knobs(), tiny_view());
  EXPECT_GT(kinds[VoxelHit], 2000);
  EXPECT_EQ(shadows, 0);
}

TEST(VoxelPicture, IsThatOfTheClosedFormsWithShadowsSlopesAndLimits) {
  voxel_knobs k = tiny_knobs();
  k.shading = VoxelShadingSlope;
  k.shadows = 1;
  k.max_outer = k.max_inner = 12;
  k.memory_clocks = 3;
  k.group_fetch = 1;
  PictureView view = tiny_view();
  view.dy[2] = 419430;  // up into the sky, too
  view.d00[2] = -12582912;
  const auto [kinds, shadows] = expect_closed_form(k, view);
  for (const int kind : {VoxelSky, VoxelHit, VoxelOuterLimit}) EXPECT_GT(kinds[kind], 100) << kind;
  EXPECT_GT(shadows, 100);
}

TEST(VoxelPicture, IsThatOfTheClosedFormsWithVoxelsThatAreHits) {
  voxel_knobs k = tiny_knobs();
  k.voxel_y = 1;
  k.leaf = VoxelLeafVoxel;
  k.shading = VoxelShadingSlope;
  k.sky = VoxelSkyGradient;
  k.debug_limits = 1;
  k.max_outer = 20;
  const auto [kinds, shadows] = expect_closed_form(k, tiny_view());
  EXPECT_GT(kinds[VoxelHit], 1000);
  EXPECT_GT(kinds[VoxelOuterLimit], 100);
}

TEST(VoxelPicture, IsTheSameWithABufferThatIsOftenFull) {
  std::mt19937 random(5);
  const voxel_knobs k = tiny_knobs();
  const voxel_world world = tiny_world(4);
  const DrawnPicture unhindered = PictureRig(world, k, any_palette()).draw(tiny_view(), always);
  const DrawnPicture held =
      PictureRig(world, k, any_palette()).draw(tiny_view(), [&] { return random() % 8 == 0; });
  EXPECT_EQ(held.colours, unhindered.colours);
  // 7 clocks a pixel, on average.
  EXPECT_NEAR(static_cast<double>(held.clocks - unhindered.clocks) / (64 * 48), 7, 0.7);
}

}  // namespace
}  // namespace racebeam
