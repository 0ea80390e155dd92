// The block renderer's pictures against the golden ones: within the bounds of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/block_golden.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/block_scenes.h"
#include "tests/support/drawn_blocks.h"

namespace racebeam {
namespace {

struct Difference {
  double by_more_than_2 = 0, by_more_than_16 = 0, rmse = 0;  // percent of pixels; of 255
};

Difference difference(const block_knobs& k, const block_tables& tables, const DrawnBlocks& drawn) {
  const BlockGolden golden(k, tables);
  Difference sum;
  int pixels = 0;
  for (int y = 0; y < k.rows(); y += 2)
    for (int x = 0; x < k.columns(); x += 2) {
      const auto is = drawn.pixel(x, y);
      const auto wanted = golden.pixel(x, y);
      double most = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double off = is[c] - wanted[c];
        most = std::max(most, std::abs(off));
        sum.rmse += off * off;
      }
      ++pixels;
      sum.by_more_than_2 += most > 2;
      sum.by_more_than_16 += most > 16;
    }
  return {100 * sum.by_more_than_2 / pixels, 100 * sum.by_more_than_16 / pixels,
          std::sqrt(sum.rmse / pixels / 3)};
}

double clocks_a_pixel(const DrawnBlocks& drawn) {
  return static_cast<double>(drawn.counters().busy_clocks) / (640 * 480);
}

TEST(BlockGolden, PixelsOfQuad) {
  const struct {
    int x, y;
    std::array<double, 3> rgb;
  } rows[] = {{320, 240, {47.4, 139.6, 93.5}},
              {160, 160, {182.0, 60.7, 60.7}},
              {480, 320, {0, 0, 0}},
              {360, 80, {130.7, 130.7, 44.5}},
              {250, 200, {62.3, 186.8, 124.6}},
              {400, 260, {8.0, 23.9, 15.9}},
              {330, 300, {20.9, 62.7, 41.8}},
              {370, 60, {124.9, 124.9, 41.6}},
              {300, 180, {80.4, 201.9, 141.1}},
              {420, 330, {10.2, 10.2, 30.5}}};
  const BlockGolden golden({}, quad_tables());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(golden.pixel(row.x, row.y)[c], row.rgb[c], 0.06) << row.x << "," << row.y;
}

TEST(BlockGolden, FirstHitIsTheNearestSphere) {
  const BlockGolden golden({}, quad_tables());
  EXPECT_EQ(golden.first_hit(320, 240), 0);
  EXPECT_EQ(golden.first_hit(160, 160), 1);
  EXPECT_EQ(golden.first_hit(0, 0), -1);
}

TEST(BlockGolden, FortySpheresInOnePassAreWithinTheBounds) {
  block_knobs k;
  k.max_passes = 1;
  k.cull = BlockCullOff;
  const block_tables tables = forty_tables();
  const DrawnBlocks drawn(k, tables);
  EXPECT_NEAR(clocks_a_pixel(drawn), 38.13, 0.005);
  const Difference d = difference(k, tables, drawn);
  EXPECT_LE(d.rmse, 4);
  EXPECT_LE(d.by_more_than_2, 8);
  EXPECT_LE(d.by_more_than_16, 0.5);
}

TEST(BlockGolden, ReflectionsMultiplyTheErrorsOfTheRoots) {
  block_knobs k;
  k.cull = BlockCullOff;
  const block_tables tables = forty_tables();
  const Difference d = difference(k, tables, DrawnBlocks(k, tables));
  EXPECT_NEAR(d.rmse, 15.2, 1);
  EXPECT_NEAR(d.by_more_than_2, 14.4, 1);
  EXPECT_NEAR(d.by_more_than_16, 4.76, 0.5);
}

TEST(BlockGolden, CornersClearMoreBlocksOfFortyThanACone) {
  block_knobs k;
  const DrawnBlocks corners(k, forty_tables());
  EXPECT_EQ(corners.counters().cleared, 413u);
  EXPECT_NEAR(clocks_a_pixel(corners), 52.04, 0.005);
  k.max_passes = 1;
  const DrawnBlocks one_pass(k, forty_tables());
  EXPECT_NEAR(clocks_a_pixel(one_pass), 31.14, 0.005);
  k.cull = BlockCullCone;
  const DrawnBlocks cone(k, forty_tables());
  EXPECT_EQ(cone.counters().cleared, 334u);
  EXPECT_EQ(cone.checksum(), one_pass.checksum());
}

TEST(BlockGolden, ShadowsAreWhereTheyBelong) {
  block_knobs k;
  k.max_passes = 1;
  const block_tables tables = quad_tables();
  const DrawnBlocks lit(k, tables);
  k.shadow_rays = 1;
  k.root = BlockRootHeron;
  const DrawnBlocks drawn(k, tables);
  EXPECT_NE(drawn.checksum(), lit.checksum());
  const Difference d = difference(k, tables, drawn);
  EXPECT_LE(d.by_more_than_2, 1);
  EXPECT_LE(d.by_more_than_16, 0.2);
}

}  // namespace
}  // namespace racebeam
