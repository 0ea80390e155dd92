// Promises of sc/block/block_core.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_core.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <random>
#include <stdexcept>
#include <vector>

#include "tb/twin/unit_bench.h"
#include "tests/block/quad.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

struct Word {
  std::uint64_t address, data;
  bool operator==(const Word& other) const {
    return address == other.address && data == other.data;
  }
};
void PrintTo(const Word& word, std::ostream* out) {
  *out << std::hex << word.address << ": " << word.data << std::dec;
}

/// A core with the spheres of quad.
template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;
  UnitBench::Pin &busy = bench["busy_o"], &state = bench["state_o"], &valid = bench["word_valid_o"],
                 &address = bench["word_address_o"], &data = bench["word_o"],
                 &ready = bench["word_ready_i"], &event = bench["event_o"];
  std::vector<Word> words;
  std::map<std::uint64_t, int> clocks;  // in each state
  std::map<std::uint64_t, int> events;

  explicit Dut(const block_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    ready.drive(1);
    bench.drive("eye", "_i", fixed_axes(quad().eye));
    bench.drive("light", "_i", fixed_axes(quad().light));
    bench.drive("start", "_i", quad_start());
    bench["ax_i"].drive(QuadStep);
    bench["ay_i"].drive(QuadStep);
    bench["spheres_i"].drive(quad().balls.size());
    for (unsigned n = 0; n < quad().balls.size(); ++n) {
      const block_ball& s = quad().balls[n];
      for (int k = 0; k < 3; ++k) {
        write(n, BlockCentreX + k, f2i(s.centre[k]), f2i(quad().eye[k]));
        write(n, BlockRed + k, f2i(s.colour[k]));
      }
      write(n, BlockRadius, f2i(s.radius));
      write(n, BlockRadius2, quad_radius2(s));
      write(n, BlockRv, quad_rv(s));
    }
    bench["write_i"].drive(0);
    bench.settle();
  }
  void write(unsigned index, int field, int value, int eye = 0) {
    bench["write_i"].drive(1);
    bench["index_i"].drive(index);
    bench["field_i"].drive(static_cast<unsigned>(field));
    bench["value_i"].drive(static_cast<std::uint32_t>(value));
    bench["eye_k_i"].drive(static_cast<std::uint32_t>(eye));
    bench.clock();
  }
  void give_job(unsigned x, unsigned y) {
    words.clear();
    clocks.clear();
    events.clear();
    bench["job_valid_i"].drive(1);
    bench["job_x_i"].drive(x);
    bench["job_y_i"].drive(y);
    bench.clock();
    bench["job_valid_i"].drive(0);
    bench.settle();
  }
  void clock() {
    ++clocks[state.value()];
    ++events[event.value()];
    if (valid.value() && ready.value()) words.push_back({address.value(), data.value()});
    bench.clock();
  }
  /// Draws a block; its clocks.
  int draw(unsigned x, unsigned y) {
    give_job(x, y);
    int all = 0;
    for (; busy.value() && all < 100'000; ++all) clock();
    return all;
  }
};

/// The words of a block, in their order; empty: `cleared`.
std::vector<Word> expected_words(int x, int y, bool cleared, const block_knobs& k) {
  std::vector<Word> words;
  const int row_words = k.columns() / 8, plane = row_words * k.rows();
  for (int row = y; row < std::min(y + BlockSide, k.rows()); ++row) {
    Word all[3][2];
    for (int column = 0; column < BlockSide; ++column) {
      quad_pixel pixel{};
      if (!cleared)
        pixel = draw_quad_pixel(x + column, row, k.max_passes, k.background, k.shadow_rays);
      for (int c = 0; c < 3; ++c) {
        Word& word = all[c][column / 8];
        const int channel =
            cleared ? k.background >> (16 - 8 * c) & 255 : pixel.rgb[static_cast<std::size_t>(c)];
        if (column % 8 == 0)
          word = {static_cast<std::uint64_t>(c * plane + row * row_words + (x + column) / 8), 0};
        word.data |= static_cast<std::uint64_t>(channel) << column % 8 * 8;
      }
    }
    for (int n = 0; n < 6; ++n) words.push_back(cleared ? all[n / 2][n % 2] : all[n % 3][n / 3]);
  }
  return words;
}

template <class Unit>
class BlockCoreTest : public testing::Test {};
TYPED_TEST_SUITE(BlockCoreTest, block_twins<block_core>);

TYPED_TEST(BlockCoreTest, ReferenceIsTheDesigns) {
  const int pixels[][6] = {{320, 240, 47, 139, 93, 48},  {160, 160, 181, 60, 60, 48},
                           {480, 320, 0, 0, 0, 12},      {360, 80, 129, 129, 44, 49},
                           {250, 200, 62, 186, 124, 48}, {400, 260, 8, 25, 17, 48},
                           {330, 300, 20, 62, 41, 48},   {370, 60, 125, 125, 41, 48},
                           {300, 180, 80, 202, 141, 48}, {420, 330, 10, 10, 32, 48}};
  for (const auto& p : pixels) {
    const quad_pixel drawn = draw_quad_pixel(p[0], p[1]);
    EXPECT_EQ(drawn.rgb, (std::array<int, 3>{p[2], p[3], p[4]})) << p[0] << ", " << p[1];
    EXPECT_EQ(drawn.clocks, p[5]);
  }
}

TYPED_TEST(BlockCoreTest, EmptyBlockIsClearedIn138Clocks) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.bench["job_ready_o"].value(), 1u);
  EXPECT_EQ(d.draw(0, 0), 138);
  EXPECT_EQ(d.clocks, (std::map<std::uint64_t, int>{
                          {BlockJob, 2}, {BlockCorner, 36}, {BlockCull, 4}, {BlockClear, 96}}));
  EXPECT_EQ(d.words, expected_words(0, 0, true, {}));
  EXPECT_EQ(d.bench["job_ready_o"].value(), 1u);
}

TYPED_TEST(BlockCoreTest, BlockAtTheMiddleTakesTheDesignsClocks) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.draw(320, 240), 12'423);
  EXPECT_EQ(d.words, expected_words(320, 240, false, {}));
  EXPECT_EQ(d.clocks[BlockCull], 1) << "the first sphere keeps it";
  EXPECT_EQ(d.clocks[BlockPixel], 256 * 9);
  EXPECT_EQ(d.clocks[BlockStore], 256);
  EXPECT_EQ(d.clocks[BlockWords], 96);
}

TYPED_TEST(BlockCoreTest, BlockWithEdgesTakesItsPixelsClocks) {
  Dut<TypeParam> d;
  int clocks = 2 + 36 + 96;
  for (int n = 0; n < 256; ++n) clocks += draw_quad_pixel(352 + n % 16, 64 + n / 16).clocks;
  const int drawn = d.draw(352, 64);
  EXPECT_EQ(drawn, clocks + d.clocks[BlockCull]);
  EXPECT_EQ(d.clocks[BlockCull], 4) << "the last sphere keeps it";
  EXPECT_EQ(d.words, expected_words(352, 64, false, {}));
}

TYPED_TEST(BlockCoreTest, WordsWaitForTheBus) {
  constexpr unsigned Seed = 17;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<TypeParam> d;
  for (const unsigned x : {320u, 0u}) {
    d.give_job(x, 240);
    while (d.busy.value()) {
      d.ready.drive(random() % 3 == 0 ? 1 : 0);
      d.bench.settle();
      d.clock();
    }
    EXPECT_EQ(d.words, expected_words(static_cast<int>(x), 240, x == 0, {}));
  }
}

TYPED_TEST(BlockCoreTest, LastBlocksOf1080RowsHaveEight) {
  block_knobs k;
  k.size = BlockSize1920;
  Dut<TypeParam> d(k);
  d.bench["ax_i"].drive(QuadStep / 3);
  d.bench["ay_i"].drive(QuadStep / 3);
  EXPECT_EQ(d.draw(1904, 1072), 2 + 36 + 4 + 48);
  EXPECT_EQ(d.words, expected_words(1904, 1072, true, k));
}

TYPED_TEST(BlockCoreTest, BackgroundIsInClearedBlocksAndBehindSpheres) {
  block_knobs k;
  k.background = 0x123456;
  Dut<TypeParam> d(k);
  d.draw(0, 0);
  EXPECT_EQ(d.words, expected_words(0, 0, true, k));
  d.draw(352, 64);
  EXPECT_EQ(d.words, expected_words(352, 64, false, k));
}

TYPED_TEST(BlockCoreTest, WithoutCullNoBlockIsCleared) {
  block_knobs k;
  k.cull = BlockCullOff;
  Dut<TypeParam> d(k);
  EXPECT_EQ(d.draw(0, 0), 2 + 256 * 12 + 96);
  EXPECT_EQ(d.words, expected_words(0, 0, false, k));
}

TYPED_TEST(BlockCoreTest, OnePassShadesOnce) {
  block_knobs k;
  k.max_passes = 1;
  Dut<TypeParam> d(k);
  d.draw(320, 240);
  EXPECT_EQ(d.words, expected_words(320, 240, false, k));
  EXPECT_EQ(d.clocks[BlockShade], 256 * 31);
  EXPECT_EQ(d.clocks[BlockGroup], 256);
}

/// A block of sphere 0 that sphere 1 is between the light and.
template <class Unit>
void expect_shadows(int max_passes) {
  constexpr int X = 256, Y = 192;
  block_knobs k;
  k.max_passes = max_passes;
  k.shadow_rays = 1;
  k.background = 0x102030;
  Dut<Unit> d(k);
  int clocks = 2 + 36 + 1 + 96, dark = 0;
  for (int n = 0; n < BlockSide * BlockSide; ++n) {
    const int x = X + n % BlockSide, y = Y + n / BlockSide;
    const quad_pixel p = draw_quad_pixel(x, y, max_passes, k.background, true);
    clocks += p.clocks;
    dark += p.rgb != draw_quad_pixel(x, y, max_passes, k.background).rgb;
  }
  EXPECT_GT(dark, 0);
  EXPECT_LT(dark, BlockSide * BlockSide);
  EXPECT_EQ(d.draw(X, Y), clocks);
  EXPECT_EQ(d.words, expected_words(X, Y, false, k));
  EXPECT_EQ(d.clocks[BlockShadow], d.clocks[BlockShade] / 31 * 10);
}
TYPED_TEST(BlockCoreTest, WhatASphereIsInTheWayOfAddsNothing) { expect_shadows<TypeParam>(1); }
TYPED_TEST(BlockCoreTest, MirrorsShowShadows) { expect_shadows<TypeParam>(3); }

TYPED_TEST(BlockCoreTest, EightPassesShadeAllTheyHit) {
  block_knobs k;
  k.max_passes = 8;
  k.background = 0x804020;
  Dut<TypeParam> d(k);
  d.draw(352, 64);
  EXPECT_EQ(d.words, expected_words(352, 64, false, k));
}

template <class Unit>
void expect_lanes(int lanes, int groups) {
  block_knobs k;
  k.lanes = lanes;
  Dut<Unit> d(k);
  d.draw(0, 0);
  EXPECT_EQ(d.clocks[BlockCull], lanes < 4 ? 4 * 4 / lanes : 4);
  d.draw(320, 240);
  EXPECT_EQ(d.words, expected_words(320, 240, false, k));
  EXPECT_EQ(d.clocks[BlockGroup] % groups, 0);
}
TYPED_TEST(BlockCoreTest, OneLaneDrawsTheSame) { expect_lanes<TypeParam>(1, 4); }
TYPED_TEST(BlockCoreTest, TwoLanesDrawTheSame) { expect_lanes<TypeParam>(2, 2); }
TYPED_TEST(BlockCoreTest, EightLanesDrawTheSame) { expect_lanes<TypeParam>(8, 1); }

TYPED_TEST(BlockCoreTest, WithoutSpheresAllIsCleared) {
  Dut<TypeParam> d;
  d.bench["spheres_i"].drive(0);
  EXPECT_EQ(d.draw(320, 240), 2 + 36 + 96);
  EXPECT_EQ(d.words, expected_words(320, 240, true, {}));
}

TYPED_TEST(BlockCoreTest, SpheresBeyondTheNumberAreNotSeen) {
  Dut<TypeParam> d;
  d.draw(320, 240);
  const std::vector<Word> before = d.words;
  d.write(4, BlockRv, 0x7fffffff);
  d.write(4, BlockRadius2, 0x7fffffff);
  d.bench["write_i"].drive(0);
  EXPECT_EQ(d.draw(320, 240), 12'423);
  EXPECT_EQ(d.words, before);
}

/// A sphere that only one corner ray meets: its centre lies on it.
template <class Unit>
void expect_corners(int lanes) {
  block_knobs k;
  k.lanes = lanes;
  Dut<Unit> d(k);
  d.bench["spheres_i"].drive(1);
  const vec3 eye = fixed_axes(quad().eye);
  constexpr int X = 320, Y = 240, Steps = BlockSide - 1, Radius2 = 0x1000;
  for (const int corner : {0, 1, 2, 3}) {
    vec3 way = quad_start();
    way[0] += QuadStep * (corner >= 2 ? X + Steps : X);
    way[1] -= QuadStep * (corner == 1 || corner == 2 ? Y + Steps : Y);
    for (int axis = 0; axis < 3; ++axis)
      d.write(0, BlockCentreX + axis, eye[axis] + way[axis], eye[axis]);
    d.write(0, BlockRv, Radius2 - inorm2(way));
    d.bench["write_i"].drive(0);
    d.draw(X, Y);
    for (const int other : {0, 1, 2, 3})
      EXPECT_EQ(d.events[static_cast<std::uint64_t>(BlockKept0 + other)], other == corner)
          << corner << other;
  }
}
TYPED_TEST(BlockCoreTest, TellsWhichCornerKeepsABlock) { expect_corners<TypeParam>(4); }
TYPED_TEST(BlockCoreTest, TellsWhichCornerKeepsABlockOfOneLane) { expect_corners<TypeParam>(1); }

TYPED_TEST(BlockCoreTest, TellsOfSmallVectors) {
  Dut<TypeParam> d;
  d.bench.drive("start", "_i", {0, 0, 0xffff});
  d.bench["ax_i"].drive(0);
  d.bench["ay_i"].drive(0);
  d.bench["spheres_i"].drive(0);
  d.draw(0, 0);
  EXPECT_EQ(d.events[BlockSmallVector], 4);
}

TYPED_TEST(BlockCoreTest, TellsOfEachRootOf8AndAbove) {
  Dut<TypeParam> d;
  d.write(0, BlockRv, 8 << BlockFraction);
  d.write(1, BlockRv, -(200 << BlockFraction));
  d.bench["write_i"].drive(0);
  d.bench["spheres_i"].drive(2);
  d.draw(320, 240);
  EXPECT_EQ(d.events[BlockRootOver], 256) << "of primary rays";
}

TYPED_TEST(BlockCoreTest, ResetDropsTheBlock) {
  Dut<TypeParam> d;
  d.give_job(320, 240);
  d.bench.clock(300);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.state.value(), static_cast<unsigned>(BlockIdle));
  EXPECT_EQ(d.busy.value(), 0u);
  d.bench["rst_ni"].drive(1);
  d.bench.settle();
  EXPECT_EQ(d.draw(320, 240), 12'423) << "as if nothing had been";
  EXPECT_EQ(d.words, expected_words(320, 240, false, {}));
}

}  // namespace
}  // namespace racebeam
