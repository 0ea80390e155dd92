// Promises of sc/block/block_normalise.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_normalise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "sc/block/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

/// The source's own: on real floats.
int inverse_root_of_floats(int aa, int steps) {
  const float square = static_cast<float>(aa >> 6) * 0x1p-14f;
  const float y = float_of_bits(0x5f3759df - (float_bits(square) >> 1));
  // Adding 768 leaves 14 fraction bits of a float; its low 23 bits are the number and 2^22.
  int x = static_cast<int>((float_bits(y + 768.0f) - 0x400000) & 0x7fffff) << 6;
  for (int n = 0; n < steps; ++n) x = imul(x, 0x180000 - imul(imul(x, x), aa >> 1));
  return x;
}

int fixed_of(double value) { return static_cast<int>(std::lround(value * 1048576)); }

TEST(InverseRoot, HasTheValuesOfTheDesign) {
  const struct {
    double aa;
    int estimate, one, two;
  } rows[] = {{0.0625, 0x3dd680, 0x3fe445, 0x3ffff0}, {0.5, 0x16eb40, 0x169f2c, 0x16a09e},
              {1, 0x0f7580, 0x0ff90e, 0x0ffffb},      {2, 0x0b7580, 0x0b4f97, 0x0b504f},
              {7.5, 0x05fac0, 0x05d668, 0x05d7a5},    {100, 0x01a6c0, 0x0198fa, 0x01999d},
              {511, 0x00b780, 0x00b52c, 0x00b537}};
  for (const auto& row : rows) {
    EXPECT_EQ(inverse_root(fixed_of(row.aa), 0), row.estimate) << row.aa;
    EXPECT_EQ(inverse_root(fixed_of(row.aa), 1), row.one) << row.aa;
    EXPECT_EQ(inverse_root(fixed_of(row.aa), 2), row.two) << row.aa;
  }
}

TEST(InverseRoot, IsTheOneOfRealFloatsInAMillionPlaces) {
  constexpr unsigned Seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  for (int n = 0; n < 1'000'000; ++n) {
    const int aa = static_cast<int>(random() >> 2 >> random() % 24) | 0x40;
    ASSERT_EQ(inverse_root(aa, 2), inverse_root_of_floats(aa, 2)) << aa;
  }
}

TEST(InverseRoot, IsAsNearAsTheDesignSays) {
  const struct {
    double from, to, bound;
  } rows[] = {{1.0 / 64, 1, 2.9e-5},
              {1, 16, 7.9e-6},
              {16, 128, 6.1e-5},
              {128, 511.9, 2.4e-4},
              {512, 1023.9, 4.7e-4}};
  for (const auto& row : rows) {
    double worst = 0;
    for (int n = 0; n <= 20'000; ++n) {
      const int aa = fixed_of(row.from * std::pow(row.to / row.from, n / 20'000.0));
      worst = std::max(worst,
                       std::abs(inverse_root(aa, 2) / 1048576.0 * std::sqrt(aa / 1048576.0) - 1));
    }
    EXPECT_LE(worst, row.bound * 1.02) << row.from;
    EXPECT_GE(worst, row.bound * 0.7) << row.from;
  }
}

TEST(F2i, HasTheValuesOfTheDesign) {
  const std::pair<float, unsigned> rows[] = {{1.0f, 0x00100000},        {-1.0f, 0xfff00000},
                                             {3.14159265f, 0x00324400}, {-2.7182818f, 0xffd48200},
                                             {255.9f, 0x0ffe6680},      {-255.9f, 0xf0019980},
                                             {0.0001f, 0x00000080},     {100.25f, 0x06440000}};
  for (const auto& [value, bits] : rows)
    EXPECT_EQ(static_cast<unsigned>(f2i(value)), bits) << value;
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
  /// The clocks from start to done.
  int run(const vec3& v) {
    bench.drive("v", "_i", v);
    bench["start_i"].drive(1);
    bench.settle();
    int clocks = 1;
    for (; !bench["done_o"].value() && clocks < 60; ++clocks) bench.clock();
    return clocks;
  }
  void end() {
    bench["start_i"].drive(0);
    bench.clock();
  }
};

template <class Unit>
class BlockNormaliseTest : public testing::Test {};
TYPED_TEST_SUITE(BlockNormaliseTest, block_twins<block_normalise>);

TYPED_TEST(BlockNormaliseTest, HasTheVectorsOfTheDesign) {
  const struct {
    double v[3];
    unsigned unit[3];
  } rows[] = {{{1, 0, 0}, {0x000ffffb, 0, 0}},
              {{0, 0, 3}, {0, 0, 0x000fffff}},
              {{1, 1, 1}, {0x00093cd3, 0x00093cd3, 0x00093cd3}},
              {{-4, 2.5, 7}, {0xfff86af0, 0x0004bd2a, 0x000d44dc}},
              {{0.5, -0.25, 0.125}, {0x000df748, 0xfff9045c, 0x00037dd2}},
              {{12, -12, 12}, {0x00093d44, 0xfff6c2bc, 0x00093d44}},
              {{-0.01, 0.02, 3}, {0xfffff255, 0x00001b55, 0x000fffe1}}};
  Dut<TypeParam> d;
  for (const auto& row : rows) {
    vec3 v, unit;
    for (int k = 0; k < 3; ++k) {
      v[k] = f2i(static_cast<float>(row.v[k]));
      unit[k] = static_cast<int>(row.unit[k]);
    }
    EXPECT_EQ(d.run(v), 9);
    EXPECT_EQ(d.bench.read("unit"), unit) << row.v[0];
    d.end();
    EXPECT_EQ(d.bench.read("unit"), vec3{}) << "without done_o";
  }
}

TYPED_TEST(BlockNormaliseTest, RandomVectorsAreTheFunctions) {
  constexpr unsigned Seed = 9;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<TypeParam> d;
  for (int n = 0; n < 2000; ++n) {
    const int shift = static_cast<int>(random() % 32);
    vec3 v;
    for (int& each : v) each = static_cast<int>(random()) >> shift;
    d.run(v);
    ASSERT_EQ(d.bench.read("unit"), inormalize(v, 2)) << v[0] << " " << v[1] << " " << v[2];
    d.end();
  }
}

template <class Unit>
void expect_clocks(int steps) {
  block_knobs k;
  k.newton_steps = steps;
  Dut<Unit> d(k);
  const vec3 v{0x123456, -0x654321, 0x1000};
  EXPECT_EQ(d.run(v), 3 + 3 * steps);
  EXPECT_EQ(d.bench.read("unit"), inormalize(v, steps));
}
TYPED_TEST(BlockNormaliseTest, TakesThreeClocksAndThreeAStep) { expect_clocks<TypeParam>(0); }
TYPED_TEST(BlockNormaliseTest, TakesSixClocksWithOneStep) { expect_clocks<TypeParam>(1); }
TYPED_TEST(BlockNormaliseTest, TakesTwelveClocksWithThreeSteps) { expect_clocks<TypeParam>(3); }

TYPED_TEST(BlockNormaliseTest, TellsOfSmallVectorsInTheSecondClock) {
  Dut<TypeParam> d;
  const auto told = [&d](int length) {
    d.bench.drive("v", "_i", {0, -length, 0});
    d.bench["start_i"].drive(1);
    std::vector<std::uint64_t> clocks;
    for (int n = 0; n < 9; ++n) {
      d.bench.clock();
      clocks.push_back(d.bench["small_o"].value());
    }
    return clocks;
  };
  const std::vector<std::uint64_t> never(9, 0), second = {1, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(told(0x10000), never);
  EXPECT_EQ(told(0xffff), second);
}

TYPED_TEST(BlockNormaliseTest, BeginsAgainInTheClockAfterDone) {
  Dut<TypeParam> d;
  d.run({0x100000, 0, 0});
  for (int n = 0; n < 3; ++n) {
    d.bench.clock();
    ASSERT_EQ(d.bench["done_o"].value(), 0u);
    d.bench.clock(8);
    ASSERT_EQ(d.bench["done_o"].value(), 1u);
  }
}

TYPED_TEST(BlockNormaliseTest, StartedItEndsWhateverStartDoes) {
  Dut<TypeParam> d;
  d.bench.drive("v", "_i", {0x100000, 0x200000, 0});
  d.bench["start_i"].drive(1);
  d.bench.clock();
  d.bench["start_i"].drive(0);
  d.bench.clock(7);
  EXPECT_EQ(d.bench["done_o"].value(), 1u);
  d.bench.clock();
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
  d.bench.clock(20);
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
}

TYPED_TEST(BlockNormaliseTest, ResetEndsIt) {
  Dut<TypeParam> d;
  d.bench["start_i"].drive(1);
  d.bench.clock(4);
  d.bench["start_i"].drive(0);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  d.bench["rst_ni"].drive(1);
  for (int n = 0; n < 12; ++n) {
    d.bench.clock();
    ASSERT_EQ(d.bench["done_o"].value(), 0u) << n;
  }
}

}  // namespace
}  // namespace racebeam
