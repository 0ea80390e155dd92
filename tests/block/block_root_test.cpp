// Promises of sc/block/block_root.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_root.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sc/block/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr int Radicands = 1 << BlockRootBits;

TEST(RootOf, HeronAndDigitsHaveTheErrorsOfTheContract) {
  double most = 0;
  for (int d = 1; d < Radicands; ++d) {
    const double exact = std::sqrt(d * 1048576.0), heron = heron_root(d);
    const int digits = exact_root(d);
    ASSERT_LE(std::int64_t{digits} * digits, std::int64_t{d} << 20) << d;
    ASSERT_GT(std::int64_t{digits + 1} * (digits + 1), std::int64_t{d} << 20) << d;
    ASSERT_GE(heron, exact - 1.5) << d;
    if (d > 1000) most = std::max(most, heron / exact - 1);
  }
  EXPECT_NEAR(most, 0.001735, 0.000001);
}

/// As the contract says it in gates: from the place of the leading one.
int root_by_place(int d) {
  if (d == 0) return 0;
  int place = 0;
  while (d >> (place + 1)) ++place;
  const double m = static_cast<double>(d - (1 << place)) / (1 << place);
  const double root = place % 2 == 0 ? std::ldexp(1 + m / 2, (place - 20) / 2)
                                     : std::ldexp(1.5 + m / 2, (place - 21) / 2);
  return static_cast<int>(std::nearbyint(std::ldexp(root, 20)));
}

TEST(Isqrt, IsTheFormInGatesForAllRadicands) {
  for (int d = 0; d < Radicands; ++d) ASSERT_EQ(isqrt(d), root_by_place(d)) << d;
}

TEST(Isqrt, IsNeverTooSmallAndNeverFalls) {
  double most = 0, sum = 0, off = 0;
  for (int d = 1; d < Radicands; ++d) {
    const double exact = std::sqrt(d / 1048576.0) * 1048576.0, root = isqrt(d);
    ASSERT_GE(root, std::floor(exact + 0.5)) << d;
    ASSERT_LE(isqrt(d - 1), root) << d;
    most = std::max(most, root / exact - 1);
    off = std::max(off, root - exact);
    sum += root / exact - 1;
  }
  EXPECT_NEAR(most, 0.06066, 0.00001);
  EXPECT_NEAR(sum / (Radicands - 1), 0.0214, 0.0001);
  EXPECT_NEAR(off / 1048576, 0.1716, 0.0001);
}

block_knobs knobs_of(int rule) {
  block_knobs k;
  k.root = rule;
  return k;
}

/// A unit that makes roots by one rule.
template <class Unit>
class Dut {
 public:
  explicit Dut(int rule) : knobs_(knobs_of(rule)), unit_("dut", knobs_), bench_(unit_) {
    bench_["rst_ni"].drive(0);
    bench_.clock();
    bench_["rst_ni"].drive(1);
    bench_["start_i"].drive(1);
  }
  /// In the clocks that the rule takes.
  std::uint64_t root(int d) {
    bench_["d_i"].drive(static_cast<unsigned>(d));
    bench_.settle();
    for (int n = 1; n < knobs_.root_clocks(); ++n) {
      EXPECT_EQ(bench_["done_o"].value(), 0u) << d;
      bench_.clock();
    }
    EXPECT_EQ(bench_["done_o"].value(), 1u) << d;
    const std::uint64_t root = bench_["root_o"].value();
    if (knobs_.root_clocks() > 1) bench_.clock();
    return root;
  }

 private:
  const block_knobs knobs_;
  Unit unit_;
  UnitBench bench_;
};

template <class Unit>
class BlockRootTest : public testing::Test {
 protected:
  void expect_all(int rule, int from, int step) {
    Dut<Unit> dut(rule);
    for (int d = from; d < Radicands; d += step)
      ASSERT_EQ(dut.root(d), static_cast<unsigned>(root_of(d, rule))) << d;
  }
};
TYPED_TEST_SUITE(BlockRootTest, block_twins<block_root>);

TYPED_TEST(BlockRootTest, HasTheRootsOfTheDesign) {
  const int rows[][2] = {{0, 0},
                         {0x000001, 0x000400},
                         {0x000003, 0x000700},
                         {0x080000, 0x0c0000},
                         {0x100000, 0x100000},
                         {0x180000, 0x140000},
                         {0x200000, 0x180000},
                         {0x300000, 0x1c0000},
                         {0x7fffff, 0x300000}};
  Dut<TypeParam> dut(BlockRootTrick);
  for (const auto& [d, root] : rows) EXPECT_EQ(dut.root(d), static_cast<unsigned>(root)) << d;
}

TYPED_TEST(BlockRootTest, IsTheFormInGates) {
  Dut<TypeParam> dut(BlockRootTrick);
  for (int d = 0; d < 3000; ++d)
    ASSERT_EQ(dut.root(d), static_cast<unsigned>(root_by_place(d))) << d;
  for (int d = 3000; d < Radicands; d += 997)
    ASSERT_EQ(dut.root(d), static_cast<unsigned>(root_by_place(d))) << d;
}

TYPED_TEST(BlockRootTest, HeronsStepIsTheFormulas) { this->expect_all(BlockRootHeron, 0, 1999); }
TYPED_TEST(BlockRootTest, DigitsAreThoseOfTheRoot) { this->expect_all(BlockRootExact, 0, 1999); }

template <class Unit>
using LongBlockRootTest = BlockRootTest<Unit>;
TYPED_TEST_SUITE(LongBlockRootTest, block_twins<block_root>);

TYPED_TEST(LongBlockRootTest, IsTheFormInGatesForAllRadicands) {
  Dut<TypeParam> dut(BlockRootTrick);
  for (int d = 0; d < Radicands; ++d)
    ASSERT_EQ(dut.root(d), static_cast<unsigned>(root_by_place(d))) << d;
}
TYPED_TEST(LongBlockRootTest, HeronsStepIsTheFormulasForManyRadicands) {
  this->expect_all(BlockRootHeron, 1, 7);
}
TYPED_TEST(LongBlockRootTest, DigitsAreThoseOfTheRootForManyRadicands) {
  this->expect_all(BlockRootExact, 1, 7);
}

}  // namespace
}  // namespace racebeam
