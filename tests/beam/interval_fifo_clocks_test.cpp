// Promises of sc/beam/interval_fifo.h: clock by clock in frame 2, contract section 14.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/interval_fifo_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using IntervalFifoClocksTest = IntervalFifoTest<Unit>;
TYPED_TEST_SUITE(IntervalFifoClocksTest, Twins);

// Frame 2, y = -240: clocks 135, 164, (179), 186..188, 194..197, 253, 274..322.
TYPED_TEST(IntervalFifoClocksTest, Frame2FillsTheQueueAndStallsUntilClock322) {
  auto& d = this->dut;
  EXPECT_TRUE(d.offer(1, 3));
  EXPECT_EQ(d.fill(), 2) << "c = 136, tail_ptr 8";
  EXPECT_TRUE(d.offer(16, 2));
  EXPECT_EQ(d.fill(), 3) << "c = 165, tail_ptr 7";
  EXPECT_TRUE(d.offer(11, 3));
  EXPECT_TRUE(d.offer(100, 1));
  EXPECT_EQ(d.fill(), 5) << "c = 187";
  EXPECT_FALSE(d.offer(95, 1)) << "the head splits";
  EXPECT_EQ(d.fill(), 6) << "c = 188, tail_ptr 4";
  EXPECT_TRUE(d.offer(95, 1)) << "merges";
  EXPECT_EQ(d.fill(), 6) << "c = 195, head 131";
  d.clock(0);
  EXPECT_EQ(d.fill(), 7);
  d.clock(0);
  EXPECT_EQ(d.fill(), 8) << "c = 197, head 3, tail_ptr 2";
  d.clock(0);
  EXPECT_EQ(d.fill(), 8);
  EXPECT_TRUE(d.offer(32, 2));
  EXPECT_TRUE(d.offer(20, 3));
  EXPECT_EQ(d.fill(), 10) << "c = 253, tail_ptr 0";
  for (int n = 0; n < 5; ++n) EXPECT_FALSE(d.offer(7, 1)) << "stalled";
  EXPECT_EQ(d.display(), 0) << "c = 320";
  EXPECT_FALSE(d.clock(1, 1, 7, 1)) << "c = 321";
  EXPECT_EQ(d.display(), 3) << "c = 322";
  EXPECT_EQ(d.fill(), 9);
  EXPECT_TRUE(d.offer(7, 1)) << "c = 322";
  // The columns that follow: 1 x 3, 16 x 2, 11 x 3, 195 x 1, 32 x 2, 20 x 3, 7 x 1.
  const int runs[][2] = {{1, 3}, {16, 2}, {11, 3}, {195, 1}, {32, 2}, {20, 3}, {7, 1}};
  for (const auto& run : runs)
    for (int n = 0; n < run[0]; ++n) {
      ASSERT_EQ(d.display(), run[1]) << n << " of " << run[0];
      d.clock(0);
      d.clock(1);
    }
  EXPECT_TRUE(d.starving());
}

// Frame 2, y = -24: clocks 971..1001.
TYPED_TEST(IntervalFifoClocksTest, LateIntervalIsShortenedByTheStarvedColumns) {
  auto& d = this->dut;
  d.offer(1, 2);
  d.clock(1);
  EXPECT_FALSE(d.starving());
  for (int n = 0; n < 15; ++n) {
    d.clock(1);  // c = 971, 973, .. 999: head_len -1 .. -15
    EXPECT_TRUE(d.starving());
    EXPECT_EQ(d.display(), 2) << "the old colour";
    if (n < 14) d.clock(0);
  }
  EXPECT_TRUE(d.offer(27, 0)) << "c = 1000";
  for (int left = 13; left > 0; --left) {  // head_len 12 at c = 1001
    EXPECT_FALSE(d.starving()) << left;
    EXPECT_EQ(d.display(), 0) << left;
    EXPECT_EQ(d.fill(), 1);
    d.clock(1);
  }
  EXPECT_TRUE(d.starving());
}

}  // namespace
}  // namespace racebeam
