// Promises of sc/beam/subdivider.h: the steps of idx2, contract sections 9.5, 9.6, 17.4 and
// vectors 20.2.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "tests/beam/subdivider_bench.h"

namespace racebeam {
namespace {

/// 9.5 in words: the power of two closest to the distance `d` / `divisor`; on a tie the larger one
/// if `up`.
int closest_step(int d, bool up, int divisor = 1) {
  int best = 1;
  for (int step = 2; step <= 1024; step *= 2) {
    const int nearer = std::abs(d - divisor * best) - std::abs(d - divisor * step);
    if (nearer > 0 || (nearer == 0 && up)) best = step;
  }
  return best;
}

template <class Unit>
using SubdividerWalkTest = SubdividerTest<Unit>;
TYPED_TEST_SUITE(SubdividerWalkTest, Twins);

// 9.5: ties go up forward and down backward; 2^10 is 0 for idx2 (9.6).
TYPED_TEST(SubdividerWalkTest, StepIsTheClosestPowerOfTwoToEveryDistance) {
  auto& d = this->dut;
  for (int distance = -1023; distance <= 1023; ++distance) {
    const int from = distance < 0 ? 1023 : 0;
    d.start(from + distance, from);
    const int size = distance ? closest_step(std::abs(distance), distance > 0) : 0;
    ASSERT_EQ(d.step(), distance < 0 ? -size : size) << "distance " << distance;
    d.clock();
    ASSERT_EQ(d.idx2(), (from + (distance < 0 ? -size : size)) & 1023) << "distance " << distance;
  }
}

// 20.2
TYPED_TEST(SubdividerWalkTest, IndexWalksAsInTheVectors) {
  auto& d = this->dut;
  const std::vector<std::vector<int>> walks = {
      {0, 512, 640, 639}, {0, 512, 510}, {0, 128, 96},    {256, 0, 16},  {512, 256, 192},
      {100, 104, 103},    {100, 98, 97}, {100, 108, 106}, {100, 96, 94}, {100, 92, 93}};
  for (const auto& walk : walks) {
    d.start(walk.back(), walk.front());
    for (const int pixel : walk) {
      EXPECT_EQ(d.idx2(), pixel) << walk.front() << " to " << walk.back();
      d.clock();
    }
  }
}

// 9.5: in bisection the power of two closest to half the width, ties up; then the split is right.
TYPED_TEST(SubdividerWalkTest, FirstBisectionStepIsClosestToHalfOfEveryWidth) {
  auto& d = this->dut;
  for (int width = 2; width <= 1023; ++width) {
    d.start(width, width);
    d.clock();
    d.see("dec_i", 1);
    ASSERT_EQ(d.state(), StateRight);
    ASSERT_EQ(d.step(), -closest_step(width, true, 2)) << "width " << width;
  }
}

TYPED_TEST(SubdividerWalkTest, TwoPixelsSplitInTheRightClock) {
  auto& d = this->dut;
  d.start(1, 1);
  EXPECT_EQ(d.split_at(0), 0);
  EXPECT_EQ(d.state(), StateRight);
  EXPECT_EQ(d.step(), -1);
  d.clock();
  EXPECT_EQ(d.i2(), 0);
  EXPECT_EQ(d.idx2(), 0);
}

template <class Unit>
void expect_all_splits(Dut<Unit>& d, int width, int most_clocks) {
  for (int last = 0; last < width; ++last) {
    d.start(width, width);
    ASSERT_LE(d.split_at(last), most_clocks) << "last " << last;
    ASSERT_TRUE(d.get("descend_o"));
    ASSERT_EQ(d.get("cur_o") & 1, 0) << "the left part descends";
    ASSERT_EQ(d.i2(), width) << "the entry holds the right end";
    d.clock();
    ASSERT_EQ(d.state(), StateLeft);
    ASSERT_EQ(d.i1(), 0);
    ASSERT_EQ(d.i2(), last);
    ASSERT_EQ(d.idx2(), last) << "dr2 stands at the new right end";
  }
}

TYPED_TEST(SubdividerWalkTest, BisectionFindsEverySwitchingPixelOfALine) {
  expect_all_splits(this->dut, 639, 14);
}

template <class Unit>
class SubdividerWalkKnobs : public testing::Test {};
TYPED_TEST_SUITE(SubdividerWalkKnobs, Twins);

// Halving 639 leaves one pixel after 10 clocks, the first of them RIGHT.
TYPED_TEST(SubdividerWalkKnobs, MidpointBisectionFindsEveryPixelInTenClocks) {
  knobs k;
  k.bisection = BisectionMidpoint;
  Dut<TypeParam> d(k);
  expect_all_splits(d, 639, 10);
}

// The power of two up to half of 639 leaves one pixel after 17 clocks at most.
TYPED_TEST(SubdividerWalkKnobs, FloorBisectionHalvesDownwardsAndFindsEveryPixel) {
  knobs k;
  k.bisection = BisectionFloor;
  Dut<TypeParam> d(k);
  for (int width = 2; width <= 1023; ++width) {
    int power = 1;
    while (4 * power <= width) power *= 2;
    d.start(width, width);
    d.clock();
    d.see("dec_i", 1);
    ASSERT_EQ(d.step(), -power) << "width " << width;
  }
  expect_all_splits(d, 639, 17);
}

// 17.4, 9.6: one pixel forward on each consume, instead of any other step.
TYPED_TEST(SubdividerWalkTest, LockStepsOnePixelOnEachConsume) {
  auto& d = this->dut;
  d.start(639, 0);
  d.see("lock_i", 1);
  EXPECT_EQ(d.step(), 0);
  for (int pixel = 1; pixel <= 100; ++pixel) {
    d.see("consume_i", 0);
    d.clock();
    d.see("consume_i", 1);
    EXPECT_EQ(d.step(), 1);
    d.clock();
    ASSERT_EQ(d.idx2(), pixel);
    ASSERT_EQ(d.state(), StateLeft) << "waits for idx2 = i2";
  }
  d.see("lock_i", 0);
  EXPECT_EQ(d.step(), 512) << "back to the tracer's own steps";
}

TYPED_TEST(SubdividerWalkTest, LockDoesNotDisturbTheCamera) {
  auto& d = this->dut;
  d.start(96, 0);
  d.set("tracer_reset_i", 1);
  d.set("consume_i", 1);
  d.see("lock_i", 1);
  EXPECT_EQ(d.step(), 128);
}

}  // namespace
}  // namespace racebeam
