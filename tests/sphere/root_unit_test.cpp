// Promises of sc/sphere/root_unit.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/root_unit.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "sc/sphere/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

/// floor(sqrt(radicand * 2^12)), by bisection.
int integer_root(int radicand) {
  const std::int64_t square = std::int64_t{radicand} << 12;
  std::int64_t low = 0, high = 1 << 18;
  while (high - low > 1) {
    const std::int64_t middle = (low + high) / 2;
    (middle * middle <= square ? low : high) = middle;
  }
  return static_cast<int>(low);
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const sphere_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock(2);
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  /// Starts a root; the edges up to done.
  int start(int radicand) {
    bench["radicand_i"].drive(static_cast<unsigned>(radicand));
    bench["start_i"].drive(1);
    int edges = 0;
    do {
      bench.clock();
      ++edges;
    } while (!bench["done_o"].value() && edges < 50);
    return edges;
  }
  void stop() {
    bench["start_i"].drive(0);
    bench.clock();
  }
  int root() { return static_cast<int>(bench["root_o"].value()); }
};

template <class Unit>
class RootUnitTest : public testing::Test {};
TYPED_TEST_SUITE(RootUnitTest, sphere_twins<root_unit>);

TYPED_TEST(RootUnitTest, RootsOfTheTable) {
  Dut<TypeParam> d;
  const int table[][2] = {
      {0x000000, 0x000000}, {0x000001, 0x000040}, {0x000002, 0x00005a}, {0x000003, 0x00006e},
      {0x0003e8, 0x0007e7}, {0x000fff, 0x000fff}, {0x001000, 0x001000}, {0x002000, 0x0016a0},
      {0x003000, 0x001bb6}, {0x004000, 0x002000}, {0x009000, 0x003000}, {0x010000, 0x004000},
      {0x100000, 0x010000}, {0x989680, 0x031691}, {0x7fffff, 0x02d413}, {0xffffff, 0x03ffff}};
  for (const auto& [radicand, root] : table) {
    EXPECT_EQ(d.start(radicand), 6);
    EXPECT_EQ(d.root(), root) << std::hex << radicand;
    d.stop();
    EXPECT_EQ(d.bench["done_o"].value(), 0u);
    EXPECT_EQ(d.root(), root) << "stays";
  }
}

TYPED_TEST(RootUnitTest, RandomRadicandsHaveTheIntegerRoot) {
  constexpr unsigned Seed = 34;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<TypeParam> d;
  for (int n = 0; n < 3000; ++n) {
    const int radicand = static_cast<int>(random() & 0xffffff) >> random() % 24;
    d.start(radicand);
    ASSERT_EQ(d.root(), integer_root(radicand)) << std::hex << radicand;
    d.stop();
  }
}

TYPED_TEST(RootUnitTest, DoneStaysUntilStartFalls) {
  Dut<TypeParam> d;
  d.start(0x9000);
  d.bench["radicand_i"].drive(0x4000);
  for (int n = 0; n < 20; ++n) {
    d.bench.clock();
    ASSERT_EQ(d.bench["done_o"].value(), 1u);
    ASSERT_EQ(d.root(), 0x3000);
  }
}

TYPED_TEST(RootUnitTest, RadicandCountsAtTheSecondEdgeOnly) {
  Dut<TypeParam> d;
  d.bench["start_i"].drive(1);
  d.bench["radicand_i"].drive(0x123456);
  d.bench.clock();
  d.bench["radicand_i"].drive(0x9000);
  d.bench.clock();
  d.bench["radicand_i"].drive(0x654321);
  d.bench.clock(4);
  EXPECT_EQ(d.bench["done_o"].value(), 1u);
  EXPECT_EQ(d.root(), 0x3000);
}

TYPED_TEST(RootUnitTest, StartThatFallsEarlyGivesTheRootUp) {
  Dut<TypeParam> d;
  d.start(0x4000);
  d.stop();
  for (int held = 1; held <= 5; ++held) {
    d.bench["radicand_i"].drive(0x9000);
    d.bench["start_i"].drive(1);
    d.bench.clock(held);
    d.bench["start_i"].drive(0);
    for (int n = 0; n < 10; ++n) {
      d.bench.clock();
      ASSERT_EQ(d.bench["done_o"].value(), 0u) << held;
    }
    EXPECT_EQ(d.root(), 0x2000) << held;
    EXPECT_EQ(d.start(0x4000), 6) << held;
    d.stop();
  }
}

TYPED_TEST(RootUnitTest, ResetClearsRootAndDone) {
  Dut<TypeParam> d;
  d.start(0x9000);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
  EXPECT_EQ(d.root(), 0);
  d.bench["rst_ni"].drive(1);
  EXPECT_EQ(d.start(0x4000), 6) << "start counts as having been 0";
}

template <class Unit>
void expect_edges(int bits, int edges) {
  sphere_knobs k;
  k.root_bits_per_clock = bits;
  Dut<Unit> d(k);
  for (const int radicand : {0x989680, 0x7fffff, 1}) {
    EXPECT_EQ(d.start(radicand), edges);
    EXPECT_EQ(d.root(), integer_root(radicand));
    d.stop();
  }
}
TYPED_TEST(RootUnitTest, OneBitAClockTakes24Edges) { expect_edges<TypeParam>(1, 24); }
TYPED_TEST(RootUnitTest, TwoBitsAClockTake13Edges) { expect_edges<TypeParam>(2, 13); }
TYPED_TEST(RootUnitTest, ThreeBitsAClockTake10Edges) { expect_edges<TypeParam>(3, 10); }
TYPED_TEST(RootUnitTest, ElevenBitsAClockTake4Edges) { expect_edges<TypeParam>(11, 4); }
TYPED_TEST(RootUnitTest, AllBitsAtOnceTake3Edges) { expect_edges<TypeParam>(22, 3); }

TEST(RootOf, AllRadicandsHaveTheIntegerRoot) {
  for (int radicand = 0; radicand < 1 << 24; ++radicand) {
    const std::int64_t root = root_of(radicand), square = std::int64_t{radicand} << 12;
    ASSERT_TRUE(root * root <= square && square < (root + 1) * (root + 1)) << std::hex << radicand;
  }
}

TEST(LongRootUnitCore, AllRadicandsHaveTheIntegerRoot) {
  sphere_knobs k;
  k.root_bits_per_clock = 22;
  for (int radicand = 0; radicand < 1 << 24; ++radicand) {
    root_unit_core core;
    for (int n = 0; n < 3; ++n) core.clock({true, true, radicand}, k);
    ASSERT_TRUE(core.done_q);
    ASSERT_EQ(core.root_q, root_of(radicand)) << std::hex << radicand;
  }
}

TEST(LongRootUnitRtl, AllRadicandsHaveTheIntegerRoot) {
  Dut<own_sphere_rtl<root_unit>> d;
  for (int radicand = 0; radicand < 1 << 24; ++radicand) {
    ASSERT_EQ(d.start(radicand), 6);
    ASSERT_EQ(d.root(), root_of(radicand)) << std::hex << radicand;
    d.stop();
  }
}

}  // namespace
}  // namespace racebeam
