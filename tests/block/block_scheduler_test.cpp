// Promises of sc/block/block_scheduler.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_scheduler.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr std::uint64_t All = ~std::uint64_t{0};

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const block_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  void start(unsigned width, unsigned height) {
    bench["width_i"].drive(width);
    bench["height_i"].drive(height);
    bench["start_i"].drive(1);
    bench.clock();
    bench["start_i"].drive(0);
    bench.settle();
  }
  void cores(std::uint64_t ready, std::uint64_t busy) {
    bench["job_ready_i"].drive(ready);
    bench["busy_i"].drive(busy);
    bench.settle();
  }
  std::uint64_t valid() { return bench["job_valid_o"].value(); }
  std::uint64_t x() { return bench["job_x_o"].value(); }
  std::uint64_t y() { return bench["job_y_o"].value(); }
  bool done() { return bench["done_o"].value() != 0; }
};

block_knobs with_cores(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

template <class Unit>
class BlockSchedulerTest : public testing::Test {};
TYPED_TEST_SUITE(BlockSchedulerTest, block_twins<block_scheduler>);

template <class Unit>
void expect_blocks(unsigned width, unsigned height) {
  Dut<Unit> d;
  d.cores(2, 0);
  d.start(width, height);
  for (unsigned y = 0; y < height; y += 16)
    for (unsigned x = 0; x < width; x += 16) {
      ASSERT_EQ(d.valid(), 2u);
      ASSERT_EQ(d.x(), x);
      ASSERT_EQ(d.y(), y);
      ASSERT_FALSE(d.done());
      d.bench.clock();
    }
  EXPECT_EQ(d.valid(), 0u);
  EXPECT_TRUE(d.done());
}
TYPED_TEST(BlockSchedulerTest, BlocksGoRowByRowOneAClock) { expect_blocks<TypeParam>(640, 480); }
TYPED_TEST(BlockSchedulerTest, LastRowMayBeClipped) { expect_blocks<TypeParam>(1920, 1080); }

TYPED_TEST(BlockSchedulerTest, LowestFreeCoreGetsTheBlock) {
  Dut<TypeParam> d(with_cores(64));
  d.start(640, 480);
  const std::uint64_t ready[] = {1, 6, 12, All, All << 63, 5, std::uint64_t{3} << 40};
  const std::uint64_t chosen[] = {1, 2, 4, 1, All << 63, 1, std::uint64_t{1} << 40};
  for (int n = 0; n < 7; ++n) {
    d.cores(ready[n], 0);
    EXPECT_EQ(d.valid(), chosen[n]) << n;
    EXPECT_EQ(d.x(), 16u * static_cast<unsigned>(n));
    d.bench.clock();
  }
}

TYPED_TEST(BlockSchedulerTest, BlockWaitsForACore) {
  Dut<TypeParam> d;
  d.start(640, 480);
  d.cores(0, 15);
  d.bench.clock(5);
  EXPECT_EQ(d.valid(), 0u);
  EXPECT_EQ(d.x(), 0u);
  d.cores(8, 7);
  EXPECT_EQ(d.valid(), 8u);
  d.bench.clock();
  EXPECT_EQ(d.x(), 16u);
}

TYPED_TEST(BlockSchedulerTest, DoneWaitsForTheLastCore) {
  Dut<TypeParam> d;
  d.cores(1, 0);
  EXPECT_TRUE(d.done()) << "before the first picture";
  d.start(16, 16);
  EXPECT_FALSE(d.done());
  d.bench.clock();
  d.cores(14, 1);
  EXPECT_FALSE(d.done());
  d.bench.clock(3);
  EXPECT_FALSE(d.done());
  d.cores(15, 0);
  EXPECT_TRUE(d.done());
}

TYPED_TEST(BlockSchedulerTest, StartCountsOnlyWhenAllIsDealt) {
  Dut<TypeParam> d;
  d.cores(1, 0);
  d.start(48, 16);
  d.bench.clock();
  d.bench["start_i"].drive(1);
  d.bench.clock();
  EXPECT_EQ(d.x(), 32u) << "goes on";
  d.bench.clock();
  EXPECT_EQ(d.valid(), 0u) << "dealt";
  d.bench.clock();
  EXPECT_EQ(d.valid(), 1u) << "begins anew";
  EXPECT_EQ(d.x(), 0u);
}

TYPED_TEST(BlockSchedulerTest, CoresThatThereAreNotDoNotCount) {
  Dut<TypeParam> d(with_cores(3));
  d.start(640, 480);
  d.cores(All << 3, 0);
  EXPECT_EQ(d.valid(), 0u);
  d.cores(All << 2, All << 3);
  EXPECT_EQ(d.valid(), 4u);
}

TYPED_TEST(BlockSchedulerTest, ResetEndsThePicture) {
  Dut<TypeParam> d;
  d.cores(1, 0);
  d.start(640, 480);
  d.bench.clock(50);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.valid(), 0u);
  EXPECT_EQ(d.x(), 0u);
  EXPECT_EQ(d.y(), 0u);
  EXPECT_TRUE(d.done());
}

}  // namespace
}  // namespace racebeam
