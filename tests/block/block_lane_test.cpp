// Promises of sc/block/block_lane.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_lane.h"

#include <gtest/gtest.h>

#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr int One = 1 << 20;

/// Bits 51..20 of a sum of products, from 128 bits.
int fixed_dot(const vec3& a, const vec3& b) {
  __int128 sum = 0;
  for (int k = 0; k < 3; ++k) sum += static_cast<__int128>(a[k]) * b[k];
  return static_cast<int>(static_cast<std::uint32_t>(sum >> 20));
}

template <class Unit>
class BlockLaneTest : public testing::Test {
 protected:
  void ask(bool secondary, const vec3& a, const vec3& dir, int k) {
    bench["secondary_i"].drive(secondary);
    bench.drive("a", "_i", a);
    bench.drive("dir", "_i", dir);
    bench["k_i"].drive(static_cast<std::uint64_t>(k));
    bench.settle();
  }
  std::int64_t b() { return bench["b_o"].signed_value(); }
  std::int64_t d() { return bench["d_o"].signed_value(); }

  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(BlockLaneTest, block_twins<block_lane>);

TYPED_TEST(BlockLaneTest, ARayAlongTheAxisMeetsAtTheRadius) {
  // From (0,0,-7) to a sphere at (0,0,6), r 2.5: k = 6.25 - 169.
  this->ask(false, {0, 0, -13 * One}, {0, 0, One}, static_cast<int>(-162.75 * One));
  EXPECT_EQ(this->b(), -13 * One);
  EXPECT_EQ(this->d(), static_cast<int>(6.25 * One));
}

TYPED_TEST(BlockLaneTest, ALaterPassTakesTwoClocksForTheSame) {
  this->ask(false, {0, 0, -13 * One}, {0, 0, One}, static_cast<int>(6.25 * One));
  this->bench.clock();
  this->ask(true, {0, 0, -13 * One}, {0, 0, One}, static_cast<int>(6.25 * One));
  EXPECT_EQ(this->b(), -13 * One);
  EXPECT_EQ(this->d(), static_cast<int>(6.25 * One));
  this->bench.clock(3);
  EXPECT_EQ(this->b(), -13 * One) << "stays";
}

TYPED_TEST(BlockLaneTest, DiscriminantsHave33Bits) {
  // b * b is just below 2^31, and so is k.
  this->ask(false, {46340 << 10, 0, 0}, {One, 0, 0}, 0x7fffffff);
  EXPECT_GT(this->d(), std::int64_t{1} << 31);
}

TYPED_TEST(BlockLaneTest, RandomRaysAreTheFormula) {
  constexpr unsigned Seed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  for (int n = 0; n < 3000; ++n) {
    const int shift = static_cast<int>(random() % 12);
    vec3 a, dir;
    for (int& each : a) each = static_cast<int>(random()) >> shift;
    for (int& each : dir) each = static_cast<int>(random()) >> shift;
    const int k = static_cast<int>(random());
    this->ask(false, a, dir, k);
    const int b = fixed_dot(a, dir), square = fixed_dot({b, 0, 0}, {b, 0, 0});
    ASSERT_EQ(this->b(), b);
    ASSERT_EQ(this->d(), signed_bits(static_cast<std::uint64_t>(std::int64_t{square} + k), 33));
    this->bench.clock();
    const vec3 other{a[1], a[2], a[0]};
    this->ask(true, other, dir, k);
    ASSERT_EQ(this->b(), b);
    ASSERT_EQ(this->d(), signed_bits(static_cast<std::uint64_t>(std::int64_t{square} + k -
                                                                fixed_dot(other, other)),
                                     33));
  }
}

}  // namespace
}  // namespace racebeam
