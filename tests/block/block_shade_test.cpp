// Promises of sc/block/block_shade.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sc/block/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr int One = 1 << 20;

struct Hit {
  vec3 position, dir;
  int distance;
  vec3 centre, light, base;
};
struct Shaded {
  vec3 point, colour, direction;
};

/// In one piece.
Shaded reference(const Hit& h, int squarings) {
  Shaded s;
  s.point = block_sum(h.position, imul(h.dir, h.distance));
  const vec3 normal = inormalize(block_difference(s.point, h.centre), 2);
  const vec3 light = inormalize(block_difference(h.light, s.point), 2);
  const int diffuse = std::max(idot(normal, light), 0);
  int bright =
      std::max(idot(h.dir, block_difference(light, imul(normal, imul(diffuse, 2 * One)))), 0);
  for (int n = 0; n < squarings; ++n) bright = imul(bright, bright);
  s.colour = block_sum(imul(h.base, diffuse), {bright, bright, bright});
  s.direction = block_difference(h.dir, imul(normal, imul(idot(h.dir, normal), 2 * One)));
  return s;
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const block_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  /// Clocks from start to done, with a block_normalise that takes `clocks`.
  int run(const Hit& h, int clocks) {
    bench.drive("position", "_i", h.position);
    bench.drive("dir", "_i", h.dir);
    bench["distance_i"].drive(static_cast<std::uint64_t>(h.distance));
    bench.drive("centre", "_i", h.centre);
    bench.drive("light", "_i", h.light);
    bench["base_red_i"].drive(static_cast<std::uint64_t>(h.base[0]));
    bench["base_green_i"].drive(static_cast<std::uint64_t>(h.base[1]));
    bench["base_blue_i"].drive(static_cast<std::uint64_t>(h.base[2]));
    bench["start_i"].drive(1);
    int all = 1;
    for (int asked = 0; all < 200; ++all) {
      bench["unit_done_i"].drive(0);
      bench.settle();
      if (bench["done_o"].value()) break;
      if (bench["normalise_o"].value() && ++asked == clocks) {
        bench.drive("unit", "_i", inormalize(bench.read("v"), 2));
        bench["unit_done_i"].drive(1);
        asked = 0;
      }
      bench.clock();
      bench["start_i"].drive(0);
    }
    return all;
  }
  vec3 colour() {
    return {static_cast<int>(bench["colour_red_o"].signed_value()),
            static_cast<int>(bench["colour_green_o"].signed_value()),
            static_cast<int>(bench["colour_blue_o"].signed_value())};
  }
  void expect(const Shaded& s) {
    ASSERT_EQ(bench.read("point"), s.point);
    ASSERT_EQ(colour(), s.colour);
    ASSERT_EQ(bench.read("direction"), s.direction);
  }
};

const Hit Straight{{0, 0, -7 * One}, {0, 0, One},      10 * One,
                   {0, 0, 5 * One},  {0, 0, -9 * One}, {One / 4, One / 2, One}};

template <class Unit>
class BlockShadeTest : public testing::Test {};
TYPED_TEST_SUITE(BlockShadeTest, block_twins<block_shade>);

TYPED_TEST(BlockShadeTest, LightBehindTheEyeIsWholeLight) {
  Dut<TypeParam> d;
  d.run(Straight, 9);
  EXPECT_EQ(d.bench.read("point"), (vec3{0, 0, 3 * One}));
  EXPECT_NEAR(d.colour()[1], One / 2 + One, One / 1000) << "base and highlight";
  EXPECT_NEAR(d.bench.read("direction")[2], -One, One / 1000) << "back to the eye";
}

TYPED_TEST(BlockShadeTest, Takes13ClocksAndTwoUnitVectors) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.run(Straight, 9), 13 + 2 * 9);
  d.bench.clock();
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
  EXPECT_EQ(d.bench.read("direction"), vec3{});
  EXPECT_EQ(d.run(Straight, 1), 13 + 2);
}

TYPED_TEST(BlockShadeTest, NoSquaringTakesFourClocksLess) {
  block_knobs k;
  k.specular_squarings = 0;
  Dut<TypeParam> d(k);
  EXPECT_EQ(d.run(Straight, 9), 9 + 2 * 9);
  d.expect(reference(Straight, 0));
}

// As in the source: a highlight asks neither for shadow nor for the side of the light.
TYPED_TEST(BlockShadeTest, LightStraightBehindTheSphereIsNoLightButAHighlight) {
  Hit dark = Straight;
  dark.light = {0, 0, 20 * One};
  Dut<TypeParam> d;
  d.run(dark, 9);
  for (const int channel : d.colour()) EXPECT_NEAR(channel, One, One / 500);
}

TYPED_TEST(BlockShadeTest, RandomHitsAreTheFormula) {
  constexpr unsigned Seed = 6;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<TypeParam> d;
  const auto vector = [&random](int shift) {
    vec3 v;
    for (int& each : v) each = static_cast<int>(random()) >> shift;
    return v;
  };
  for (int n = 0; n < 500; ++n) {
    const Hit h{
        vector(7), inormalize(vector(8), 2), static_cast<int>(random() >> 8), vector(7), vector(7),
        vector(12)};
    d.run(h, 1 + n % 9);
    ASSERT_NO_FATAL_FAILURE(d.expect(reference(h, 4))) << n;
    d.bench.clock();
  }
}

TYPED_TEST(BlockShadeTest, ResetEndsIt) {
  Dut<TypeParam> d;
  d.bench["start_i"].drive(1);
  d.bench.clock(2);
  d.bench["start_i"].drive(0);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.bench["normalise_o"].value(), 0u);
}

}  // namespace
}  // namespace racebeam
