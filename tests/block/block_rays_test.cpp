// Promises of sc/block/block_rays.h: the vectors of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "sc/block/numbers.h"
#include "tests/support/block_scenes.h"
#include "tests/support/drawn_blocks.h"

namespace racebeam {
namespace {

std::uint64_t all(const std::array<std::uint64_t, BlockMaxPasses>& shades) {
  return std::accumulate(shades.begin(), shades.end(), std::uint64_t{0});
}

TEST(BlockWorld, QuadIsConvertedAsInTheDesign) {
  const block_world world = converted(quad_tables(), {});
  const auto code = [](std::uint32_t bits) { return static_cast<int>(bits); };
  EXPECT_EQ(world.ax, 0x3333);
  EXPECT_EQ(world.ay, 0x3333);
  EXPECT_EQ(world.start, (vec3{code(0xffc00000), 0x00300000, 0x00700000}));
  const struct {
    vec3 pose;
    int radius2, rv;
  } rows[4] = {
      {{0, 0, code(0xff300000)}, 0x00640000, code(0xf5d40000)},
      {{0x00200000, code(0xfff00000), code(0xff700000)}, 0x00090000, code(0xfaa90000)},
      {{code(0xffe00000), 0x00100000, code(0xff600000)}, 0x00090000, code(0xf9790000)},
      {{code(0xfff80000), code(0xffe00000), code(0xff800000)}, 0x00090000, code(0xfbc50000)}};
  ASSERT_EQ(world.rows.size(), 4u);
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_EQ(world.rows[n].pose, rows[n].pose) << n;
    EXPECT_EQ(world.rows[n].radius2, rows[n].radius2) << n;
    EXPECT_EQ(world.rows[n].rv, rows[n].rv) << n;
  }
}

TEST(BlockWorld, FractionBitsAreCutDown) {
  block_knobs k;
  k.fraction_bits = 12;
  block_tables tables;
  tables.balls = {{{0.9999f, -0.0001f, 1}, 1, {}}};
  const block_world world = converted(tables, k);
  EXPECT_EQ(world.rows[0].centre, (vec3{0xfff00, -256, 1 << 20}));
}

TEST(BlockRays, QuadTakesTheClocksOfTheDesign) {
  const DrawnBlocks drawn({}, quad_tables());
  const block_counters& n = drawn.counters();
  EXPECT_EQ(n.busy_clocks, 3172601u);
  EXPECT_EQ(n.blocks, 1200u);
  EXPECT_EQ(n.cleared, 936u);
  EXPECT_EQ(std::accumulate(n.kept_by_corner.begin(), n.kept_by_corner.end(), std::uint64_t{0}),
            n.blocks - n.cleared);
  EXPECT_EQ(n.groups, 127921u);
  EXPECT_EQ(n.roots, 127494u);
  EXPECT_EQ(all(n.shades), 60906u);
  EXPECT_EQ(n.words, 640u * 480 / 8 * 3);
  EXPECT_EQ(n.root_out_of_range, 0u);
  EXPECT_EQ(n.small_vectors, 0u);
  EXPECT_EQ(drawn.clocks(0, 0), 138);
  EXPECT_EQ(drawn.clocks(20, 15), 12423);
  EXPECT_EQ(drawn.checksum(), 0xe7be7668u);
}

TEST(BlockRays, PixelsOfQuad) {
  const DrawnBlocks drawn({}, quad_tables());
  const struct {
    int x, y;
    std::array<int, 3> rgb;
  } rows[] = {{320, 240, {47, 139, 93}}, {160, 160, {181, 60, 60}},  {480, 320, {0, 0, 0}},
              {360, 80, {129, 129, 44}}, {250, 200, {62, 186, 124}}, {400, 260, {8, 25, 17}},
              {330, 300, {20, 62, 41}},  {370, 60, {125, 125, 41}},  {300, 180, {80, 202, 141}},
              {420, 330, {10, 10, 32}}};
  for (const auto& row : rows) EXPECT_EQ(drawn.pixel(row.x, row.y), row.rgb) << row.x;
}

TEST(BlockRays, WordsAreOfferedInOrderAndPlanesFollowEachOther) {
  block_rays rays({}, converted(quad_tables(), {}));
  for (const int x : {0, 320}) {
    const block_job& job = rays.job(x, 240);
    ASSERT_EQ(job.words.size(), 96u);
    EXPECT_LT(job.words.back().clock, job.clocks);
    for (std::size_t n = 1; n < 96; ++n)
      EXPECT_GT(job.words[n].clock, job.words[n - 1].clock) << x << ", word " << n;
  }
  const block_job& job = rays.job(320, 240);
  for (std::size_t n = 0; n < 96; n += 3)
    for (std::size_t plane = 0; plane < 3; ++plane)
      EXPECT_EQ(job.words[n + plane].address, static_cast<int>(plane) * 38400 +
                                                  (240 + static_cast<int>(n / 6)) * 80 + 40 +
                                                  static_cast<int>(n / 3 % 2));
}

TEST(BlockRays, LastRowOf1080IsHalfABlock) {
  block_knobs k;
  k.size = BlockSize1920;
  block_rays rays(k, converted(quad_tables(), k));
  EXPECT_EQ(rays.job(0, 1072).words.size(), 48u);
  EXPECT_EQ(rays.job(0, 1056).words.size(), 96u);
}

TEST(BlockRays, BackgroundIsSeenInClearedAndInKeptBlocks) {
  block_knobs k;
  k.background = 0x102030;
  const DrawnBlocks drawn(k, quad_tables());
  const std::array<int, 3> background{0x10, 0x20, 0x30};
  EXPECT_EQ(drawn.pixel(0, 0), background);
  EXPECT_EQ(drawn.pixel(480, 320), background);
  EXPECT_EQ(drawn.pixel(320, 240), (std::array<int, 3>{47, 139, 93}));
}

TEST(BlockRays, NothingIsSeenWithoutSpheres) {
  for (const int cull : {BlockCullCorners, BlockCullCone, BlockCullOff}) {
    block_knobs k;
    k.cull = cull;
    block_rays rays(k, converted({}, k));
    const block_job& job = rays.job(0, 0);
    EXPECT_EQ(job.cleared, cull != BlockCullOff);
    for (const block_word& word : job.words) EXPECT_EQ(word.pixels, 0u);
  }
}

TEST(BlockRays, ALightThatNothingStandsBeforeCostsClocksOnly) {
  block_knobs k;
  block_tables tables = quad_tables();
  tables.balls.resize(1);
  const DrawnBlocks without(k, tables);
  k.shadow_rays = 1;
  const DrawnBlocks with(k, tables);
  const std::uint64_t shades = all(without.counters().shades);
  EXPECT_EQ(with.checksum(), without.checksum());
  EXPECT_EQ(with.counters().busy_clocks - without.counters().busy_clocks, shades * (9 + 1 + 2));
  EXPECT_EQ(with.counters().groups - without.counters().groups, shades);
}

TEST(BlockRays, LanesChangeTheClocksOnly) {
  const std::array<std::uint64_t, 2> rows[] = {{1, 3749278}, {2, 3364824}, {8, 3172601}};
  for (const auto& [lanes, clocks] : rows) {
    block_knobs k;
    k.lanes = static_cast<int>(lanes);
    const DrawnBlocks drawn(k, quad_tables());
    EXPECT_EQ(drawn.checksum(), 0xe7be7668u) << lanes;
    EXPECT_EQ(drawn.counters().roots, 127494u) << lanes;
    EXPECT_EQ(drawn.counters().busy_clocks, clocks) << lanes;
  }
}

/// Pixels that show a sphere, and those of them in blocks that were cleared.
struct Lost {
  std::uint64_t seen = 0, by_corners = 0, by_cone = 0;
};

/// Of a sphere in the screen's plane whose radius is so many pixels, in 600 places; the eye is so
/// far away.
Lost lost_pixels(double radius, double eye) {
  constexpr double PixelsPerUnit = 80;
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * random() / 0x1p32;
  };
  Lost lost;
  for (int place = 0; place < 600; ++place) {
    const double x = between(-300, 300), y = between(-220, 220);
    block_tables tables;
    tables.eye = {0, 0, static_cast<float>(-eye)};
    tables.balls = {
        {{static_cast<float>(x / PixelsPerUnit), static_cast<float>(y / PixelsPerUnit), 0},
         static_cast<float>(radius / PixelsPerUnit),
         {1, 1, 1}}};
    block_knobs k;
    k.max_passes = 1;
    const block_world world = converted(tables, k);
    block_rays corners(k, world);
    k.cull = BlockCullCone;
    block_rays cone(k, world);
    k.cull = BlockCullOff;
    block_rays whole(k, world);
    const double reach = radius * 1.3 + 8;  // of the middle of a block that can show it
    for (int by = 0; by < 480; by += BlockSide)
      for (int bx = 0; bx < 640; bx += BlockSide) {
        if (std::abs(bx + 8 - 320 - x) > reach || std::abs(by + 8 - 240 + y) > reach) continue;
        whole.job(bx, by);
        block_counters n;
        whole.take(n);
        lost.seen += n.shades[0];
        if (corners.job(bx, by).cleared) lost.by_corners += n.shades[0];
        if (cone.job(bx, by).cleared) lost.by_cone += n.shades[0];
      }
  }
  return lost;
}
double percent(std::uint64_t part, const Lost& lost) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(lost.seen);
}

TEST(BlockCull, CornersLoseSpheresSmallerThanABlockAndAConeNone) {
  const double rows[][2] = {{1.6, 84.9}, {3.2, 73.3}, {4.8, 56.3}, {6.4, 29.7},
                            {8, 8.2},    {10.4, 0.6}, {16, 0.1},   {32, 0}};
  for (const auto& [radius, share] : rows) {
    const Lost lost = lost_pixels(radius, 7);
    EXPECT_NEAR(percent(lost.by_corners, lost), share, 1) << radius;
    EXPECT_EQ(lost.by_cone, 0u) << radius;
  }
}

// A unit vector is up to 1e-4 too long, and the square of the way to a sphere that much too large:
// one that is far away and small looks larger than it is.
TEST(BlockCull, SharesOfSmallSpheresFallWithTheEyesDistance) {
  const double rows[][2] = {{4, 94.0}, {9, 69.9}, {12, 25.1}};
  for (const auto& [eye, share] : rows) {
    const Lost lost = lost_pixels(1.6, eye);
    EXPECT_NEAR(percent(lost.by_corners, lost), share, 1) << eye;
  }
}

}  // namespace
}  // namespace racebeam
