// Promises of sc/sphere/vector_unit.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/vector_unit.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class VectorUnitTest : public testing::Test {
 protected:
  void ask(int op, const vec3& a, const vec3& b, int s) {
    bench["op_i"].drive(static_cast<unsigned>(op));
    bench.drive("a", "_i", a);
    bench.drive("b", "_i", b);
    bench["s_i"].drive(static_cast<unsigned>(s) & 0xffffff);
    bench.settle();
  }
  std::int64_t sum() { return bench["sum_o"].signed_value(); }

  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(VectorUnitTest, sphere_twins<vector_unit>);

TYPED_TEST(VectorUnitTest, DotIsTheExactSum) {
  this->ask(VectorDot, {3, -5, 7}, {11, 13, -17}, 99);
  EXPECT_EQ(this->sum(), 33 - 65 - 119);
}

TYPED_TEST(VectorUnitTest, ProductsAreRoundedDown) {
  this->ask(VectorScale, {4097, -1, -4096}, {5, 5, 5}, 4096);
  EXPECT_EQ(this->bench.read("product"), (vec3{4097, -1, -4096}));
  this->ask(VectorScale, {1, -1, 4095}, {}, 1);
  EXPECT_EQ(this->bench.read("product"), (vec3{0, -1, 0}));
}

TYPED_TEST(VectorUnitTest, SquareIsOfTheScalar) {
  this->ask(VectorSquare, {1, 2, 3}, {4, 5, 6}, -0x800000);
  EXPECT_EQ(this->bench["square_o"].signed_value(), std::int64_t{1} << 46);
}

TYPED_TEST(VectorUnitTest, SumWrapsAt48Bits) {
  constexpr int Least = -0x800000;
  this->ask(VectorDot, {Least, Least, Least}, {Least, Least, Least}, 0);
  EXPECT_EQ(this->sum(), (std::int64_t{3} << 46) - (std::int64_t{1} << 48));
}

TYPED_TEST(VectorUnitTest, AllOutputsFollowTheLanesWhateverTheOperation) {
  constexpr unsigned Seed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  const auto number = [&random] {
    return static_cast<int>(signed_bits(random(), 24)) >> random() % 24;
  };
  for (int n = 0; n < 5000; ++n) {
    const int op = static_cast<int>(random() % 4), s = number();
    const vec3 a{number(), number(), number()}, b{number(), number(), number()};
    this->ask(op, a, b, s);
    std::int64_t lane[3];
    for (int k = 0; k < 3; ++k)
      lane[k] = op == 0   ? std::int64_t{a[k]} * b[k]
                : op == 1 ? std::int64_t{a[k]} * s
                          : std::int64_t{s} * s;
    const auto cut = [](std::int64_t value, int bits) {
      return signed_bits(static_cast<std::uint64_t>(value), bits);
    };
    ASSERT_EQ(this->sum(), cut(lane[0] + lane[1] + lane[2], 48));
    ASSERT_EQ(this->bench["square_o"].signed_value(), cut(lane[0], 48));
    const vec3 product = this->bench.read("product");
    for (int k = 0; k < 3; ++k) ASSERT_EQ(product[k], cut(lane[k] >> 12, 24)) << op;
  }
}

}  // namespace
}  // namespace racebeam
