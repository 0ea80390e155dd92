// Promises of sc/beam/interval_fifo.h: contract section 14.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/interval_fifo.h"

#include <gtest/gtest.h>

#include "tests/beam/interval_fifo_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(IntervalFifoTest, Twins);

TYPED_TEST(IntervalFifoTest, StartsWithOnePixelOfIndex0) {
  auto& d = this->dut;
  EXPECT_EQ(d.fill(), 1);
  EXPECT_EQ(d.display(), 0);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, AcceptedIntervalIsShownAfterColumn0FromTheNextClockOn) {
  auto& d = this->dut;
  EXPECT_TRUE(d.offer(2, 3));
  EXPECT_EQ(d.display(), 0);
  EXPECT_EQ(d.fill(), 2);
  d.clock(1);
  EXPECT_EQ(d.display(), 3);
  d.clock(1);
  EXPECT_EQ(d.display(), 3);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, IntervalShorterThanTheDebtLeavesTheBeamStarving) {
  auto& d = this->dut;
  for (int n = 0; n < 6; ++n) d.clock(1);
  EXPECT_TRUE(d.offer(5, 3)) << "debt 5";
  EXPECT_TRUE(d.starving());
  EXPECT_EQ(d.display(), 3) << "the colour changes in the middle of a pixel";
  EXPECT_TRUE(d.offer(1, 1));
  EXPECT_FALSE(d.starving());
  EXPECT_EQ(d.display(), 1);
}

TYPED_TEST(IntervalFifoTest, HeadAloneBeingEatenTakesNoOffer) {
  auto& d = this->dut;
  EXPECT_FALSE(d.clock(1, 1, 4, 0)) << "same colour";
  EXPECT_FALSE(d.clock(1, 1, 4, 2)) << "starving";
  EXPECT_TRUE(d.clock(0, 1, 4, 2));
  EXPECT_FALSE(d.starving());
}

TYPED_TEST(IntervalFifoTest, OffersAreTakenWhileAnOlderEntryIsEaten) {
  auto& d = this->dut;
  d.offer(5, 1);
  EXPECT_TRUE(d.clock(1, 1, 3, 1)) << "merges while column 0 ends";
  EXPECT_EQ(d.fill(), 1);
  for (int n = 0; n < 8; ++n) {
    EXPECT_EQ(d.display(), 1);
    EXPECT_FALSE(d.starving());
    d.clock(1);
  }
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, OwnColourMergesIntoOneEntry) {
  auto& d = this->dut;
  d.offer(1, 2);
  for (int n = 0; n < 63; ++n) EXPECT_TRUE(d.offer(1, 2));
  EXPECT_EQ(d.fill(), 2);
  EXPECT_TRUE(d.offer(1, 3));
  EXPECT_EQ(d.fill(), 3);
}

// head_len >= 64 splits: 64 pixels do not, 65 do.
TYPED_TEST(IntervalFifoTest, HeadOf65PixelsShedsAnEntryOf64) {
  auto& d = this->dut;
  d.offer(64, 2);
  EXPECT_TRUE(d.offer(1, 2)) << "64 pixels stay whole";
  EXPECT_EQ(d.fill(), 2);
  EXPECT_FALSE(d.offer(1, 2)) << "65 pixels split";
  EXPECT_EQ(d.fill(), 3);
  EXPECT_TRUE(d.offer(1, 2));
  d.clock(1);
  for (int n = 0; n < 66; ++n, d.clock(1)) ASSERT_EQ(d.display(), 2) << n;
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, LoneLongHeadIsNotSplitInAClockThatEatsIt) {
  auto& d = this->dut;
  d.clock(1);
  d.offer(641, 1);  // starving: becomes the head
  EXPECT_EQ(d.fill(), 1);
  d.clock(1);
  EXPECT_EQ(d.fill(), 1) << "eaten";
  d.clock(0);
  EXPECT_EQ(d.fill(), 2) << "split";
  for (int n = 0; n < 640; ++n, d.clock(1)) ASSERT_FALSE(d.starving()) << n;
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, PushHeldWhileFullIsNotLost) {
  auto& d = this->dut;
  d.fill_up(Entries);
  EXPECT_EQ(d.fill(), Entries);
  for (int n = 0; n < 20; ++n) EXPECT_FALSE(d.offer(5, 2));
  EXPECT_FALSE(d.clock(1, 1, 5, 2)) << "still full in the clock that eats an entry";
  EXPECT_TRUE(d.clock(0, 1, 5, 2)) << "free in the next";
  EXPECT_EQ(d.fill(), Entries);
  for (int n = 1; n < Entries - 1; ++n, d.clock(1)) EXPECT_EQ(d.display(), n % 2 ? 3 : 2);
  EXPECT_EQ(d.display(), 1);
  d.clock(1);
  for (int n = 0; n < 5; ++n, d.clock(1)) EXPECT_EQ(d.display(), 2);
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, FullQueueStillMergesItsOwnColourUpTo1024Pixels) {
  auto& d = this->dut;
  d.fill_up(Entries, 640);
  EXPECT_TRUE(d.offer(383, 1)) << "full: the long head does not split, and merges";
  EXPECT_FALSE(d.offer(2, 1)) << "1025 pixels do not fit";
  EXPECT_TRUE(d.offer(1, 1)) << "1024 do";
  EXPECT_FALSE(d.offer(1, 1)) << "held";
  EXPECT_EQ(d.fill(), Entries);
}

TYPED_TEST(IntervalFifoTest, OwnColourThatWouldOverflowTheHeadBecomesAnEntry) {
  auto& d = this->dut;
  d.offer(20, 2);
  EXPECT_TRUE(d.offer(1005, 2));
  EXPECT_EQ(d.fill(), 3) << "not merged";
  d.reset();
  d.offer(20, 2);
  EXPECT_TRUE(d.offer(1004, 2));
  EXPECT_EQ(d.fill(), 2) << "merged to 1024";
  d.reset();
  EXPECT_TRUE(d.offer(1024, 0));
  EXPECT_EQ(d.fill(), 2) << "not merged with column 0";
}

TYPED_TEST(IntervalFifoTest, AckNeedsAnOffer) {
  auto& d = this->dut;
  d.drive(0, 0, 5, 0);
  EXPECT_FALSE(d.ack());
  d.drive(0, 1, 5, 0);
  EXPECT_TRUE(d.ack()) << "in the same clock";
  d.drive(1, 1, 5, 0);
  EXPECT_FALSE(d.ack()) << "follows consume too";
}

TYPED_TEST(IntervalFifoTest, ResetDropsEverything) {
  auto& d = this->dut;
  d.fill_up(Entries, 300);
  for (int n = 0; n < 4; ++n) d.clock(1);
  d.bench["tracer_reset_i"].drive(1);
  d.clock(1, 1, 200, 3);
  d.bench["tracer_reset_i"].drive(0);
  d.clock(0);
  EXPECT_EQ(d.fill(), 1);
  EXPECT_EQ(d.display(), 0);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

template <class Unit>
class IntervalFifoKnobs : public testing::Test {};
TYPED_TEST_SUITE(IntervalFifoKnobs, Twins);

TYPED_TEST(IntervalFifoKnobs, QueueOf3EntriesIsFullWith3) {
  knobs k;
  k.fifo_entries = 3;
  Dut<TypeParam> d(k);
  EXPECT_TRUE(d.offer(1, 1));
  EXPECT_TRUE(d.offer(1, 2));
  EXPECT_EQ(d.fill(), 3);
  EXPECT_FALSE(d.offer(1, 3));
  EXPECT_FALSE(d.clock(1, 1, 1, 3));
  EXPECT_TRUE(d.offer(1, 3));
}

TYPED_TEST(IntervalFifoKnobs, WithoutMergingEveryIntervalIsAnEntryUnlessTheBeamStarves) {
  knobs k;
  k.fifo_merge = 0;
  Dut<TypeParam> d(k);
  d.clock(1);
  EXPECT_TRUE(d.offer(1, 2)) << "starving: becomes the head";
  EXPECT_EQ(d.fill(), 1);
  for (int n = 2; n <= 10; ++n) {
    EXPECT_TRUE(d.offer(1, 2));
    EXPECT_EQ(d.fill(), n);
  }
  EXPECT_FALSE(d.offer(1, 2)) << "full";
  for (int n = 0; n < 10; ++n, d.clock(1)) {
    EXPECT_EQ(d.display(), 2);
    EXPECT_FALSE(d.starving());
  }
  EXPECT_TRUE(d.starving());
}

// Knob dithering = checkered: a colour is an index and a half tone.
TYPED_TEST(IntervalFifoKnobs, CheckeredNeighboursOfOneIndexButOtherHalfTonesDoNotMerge) {
  knobs k;
  k.dithering = DitheringCheckered;
  Dut<TypeParam> d(k);
  const auto offer = [&d](int pixels, int value, int half) {
    d.bench["half_i"].drive(half);
    return d.offer(pixels, value);
  };
  EXPECT_TRUE(offer(2, 1, 0));
  EXPECT_TRUE(offer(1, 1, 0));
  EXPECT_EQ(d.fill(), 2) << "one colour: merged";
  EXPECT_TRUE(offer(1, 1, 1));
  EXPECT_TRUE(offer(2, 2, 1));
  EXPECT_EQ(d.fill(), 4);
  d.clock(1);
  const int shown[6][2] = {{1, 0}, {1, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 1}};
  for (const auto& [index, half] : shown) {
    EXPECT_EQ(d.display(), index);
    EXPECT_EQ(d.bench["display_half_o"].value(), static_cast<unsigned>(half));
    d.clock(1);
  }
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, WithoutTheKnobHalfTonesHaveNoEffect) {
  auto& d = this->dut;
  for (const int half : {0, 1, 0}) {
    d.bench["half_i"].drive(half);
    d.offer(1, 2);
    EXPECT_EQ(d.fill(), 2);
    EXPECT_EQ(d.bench["display_half_o"].value(), 0u);
  }
}

}  // namespace
}  // namespace racebeam
