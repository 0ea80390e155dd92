// Promises of sc/sphere/divider_unit.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/divider_unit.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "sc/sphere/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

using Numerators = std::array<std::int64_t, 3>;

/// By magnitudes: the low 24 bits of the quotient's, with the sign.
int reference(std::int64_t numerator, int denominator) {
  if (denominator == 0) return numerator < 0 ? -0x7fffff : 0x7fffff;
  const std::int64_t size = std::llabs(numerator) / std::llabs(denominator) & 0xffffff;
  const std::int64_t value = (numerator < 0) != (denominator < 0) ? -size : size;
  return static_cast<int>(signed_bits(static_cast<std::uint64_t>(value), 24));
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
  void drive(const Numerators& n, int denominator) {
    bench["numerator_x_i"].drive(static_cast<std::uint64_t>(n[0]) & 0xfffffffff);
    bench["numerator_y_i"].drive(static_cast<std::uint64_t>(n[1]) & 0xfffffffff);
    bench["numerator_z_i"].drive(static_cast<std::uint64_t>(n[2]) & 0xfffffffff);
    bench["denominator_i"].drive(static_cast<unsigned>(denominator) & 0xffffff);
  }
  int start(const Numerators& n, int denominator) {
    drive(n, denominator);
    bench["start_i"].drive(1);
    int edges = 0;
    do {
      bench.clock();
      ++edges;
    } while (!bench["done_o"].value() && edges < 60);
    return edges;
  }
  void stop() {
    bench["start_i"].drive(0);
    bench.clock();
  }
  vec3 quotient() { return bench.read("quotient"); }
};

template <class Unit>
class DividerUnitTest : public testing::Test {};
TYPED_TEST_SUITE(DividerUnitTest, sphere_twins<divider_unit>);

TYPED_TEST(DividerUnitTest, QuotientsGoTowardsZeroInFiveEdges) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.start({7, -7, 0}, 2), 5);
  EXPECT_EQ(d.quotient(), (vec3{3, -3, 0}));
  d.stop();
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
  EXPECT_EQ(d.quotient(), (vec3{3, -3, 0})) << "stay";
  EXPECT_EQ(d.start({7, -7, 1}, -2), 5);
  EXPECT_EQ(d.quotient(), (vec3{-3, 3, 0}));
}

TYPED_TEST(DividerUnitTest, DenominatorZeroGivesTheLargest) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.start({5, -5, 0}, 0), 5);
  EXPECT_EQ(d.quotient(), (vec3{0x7fffff, -0x7fffff, 0x7fffff}));
}

TYPED_TEST(DividerUnitTest, ExtremesKeepTheLow24Bits) {
  Dut<TypeParam> d;
  constexpr std::int64_t Least = -(std::int64_t{1} << 35), Most = -Least - 1;
  for (const int denominator : {1, -1, 3, 0x7fffff, -0x800000}) {
    d.start({Least, Most, -1}, denominator);
    EXPECT_EQ(d.quotient(), (vec3{reference(Least, denominator), reference(Most, denominator),
                                  reference(-1, denominator)}))
        << denominator;
    d.stop();
  }
}

TYPED_TEST(DividerUnitTest, RandomDivisionsAreExact) {
  constexpr unsigned Seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937_64 random(Seed);
  Dut<TypeParam> d;
  for (int n = 0; n < 3000; ++n) {
    Numerators top;
    for (auto& each : top) each = signed_bits(random(), 36) >> random() % 36;
    const int bottom = static_cast<int>(signed_bits(random(), 24)) >> random() % 24;
    d.start(top, bottom);
    ASSERT_EQ(d.quotient(), (vec3{reference(top[0], bottom), reference(top[1], bottom),
                                  reference(top[2], bottom)}))
        << top[0] << " " << top[1] << " " << top[2] << " / " << bottom;
    d.stop();
    for (const auto each : top) ASSERT_EQ(quotient_of(each, bottom), reference(each, bottom));
  }
}

TYPED_TEST(DividerUnitTest, OperandsCountAtTheFirstEdgeOnly) {
  Dut<TypeParam> d;
  d.drive({1000, 2000, 3000}, 10);
  d.bench["start_i"].drive(1);
  d.bench.clock();
  d.drive({1, 2, 3}, 1);
  d.bench.clock(20);
  EXPECT_EQ(d.bench["done_o"].value(), 1u);
  EXPECT_EQ(d.quotient(), (vec3{100, 200, 300}));
}

TYPED_TEST(DividerUnitTest, StartThatFallsEarlyWritesNothing) {
  Dut<TypeParam> d;
  d.start({10, 20, 30}, 10);
  d.stop();
  for (int held = 1; held <= 4; ++held) {
    d.drive({99, 99, 99}, 1);
    d.bench["start_i"].drive(1);
    d.bench.clock(held);
    d.bench["start_i"].drive(0);
    for (int n = 0; n < 8; ++n) {
      d.bench.clock();
      ASSERT_EQ(d.bench["done_o"].value(), 0u) << held;
    }
    EXPECT_EQ(d.quotient(), (vec3{1, 2, 3})) << held;
  }
}

TYPED_TEST(DividerUnitTest, ResetClearsAll) {
  Dut<TypeParam> d;
  d.start({10, 20, 30}, 10);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.quotient(), (vec3{0, 0, 0}));
  EXPECT_EQ(d.bench["done_o"].value(), 0u);
}

template <class Unit>
void expect_edges(int clocks) {
  sphere_knobs k;
  k.divide_clocks = clocks;
  Dut<Unit> d(k);
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(d.start({123456789012 >> 2, -987654321, n}, 4711), clocks);
    EXPECT_EQ(d.quotient(), (vec3{reference(123456789012 >> 2, 4711), reference(-987654321, 4711),
                                  reference(n, 4711)}));
    d.stop();
  }
}
TYPED_TEST(DividerUnitTest, OneClockIsEnoughIfAskedFor) { expect_edges<TypeParam>(1); }
TYPED_TEST(DividerUnitTest, SevenClocksLeaveTheLastOneLess) { expect_edges<TypeParam>(7); }
TYPED_TEST(DividerUnitTest, TwentyClocksLeaveTheLastOnesIdle) { expect_edges<TypeParam>(20); }
TYPED_TEST(DividerUnitTest, ABitAClockTakes36Edges) { expect_edges<TypeParam>(36); }

}  // namespace
}  // namespace racebeam
