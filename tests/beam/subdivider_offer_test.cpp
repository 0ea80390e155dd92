// Promises of sc/beam/subdivider.h: when an interval is offered, once, contract sections 9.3
// and 9.8.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/subdivider_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using SubdividerOfferTest = SubdividerTest<Unit>;
TYPED_TEST_SUITE(SubdividerOfferTest, Twins);

TYPED_TEST(SubdividerOfferTest, OfferIsHeldInReturnUntilAcceptedAndMadeOnce) {
  auto& d = this->dut;
  d.start(20, 20);
  d.set("tag_i", tag_of(2, 6));
  d.see("top_tag_i", tag_of(1, 6));
  EXPECT_FALSE(d.get("emit_o"));
  d.see("wall_i", 1);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_FALSE(d.get("climb_o")) << "no climb before the accept (11.8)";
  d.clock();
  d.see("wall_i", 0);
  for (int n = 0; n < 5; ++n, d.clock()) {
    EXPECT_EQ(d.state(), StateReturn);
    EXPECT_TRUE(d.get("emit_o"));
    EXPECT_EQ(d.get("len_m1_o"), 20);
    EXPECT_FALSE(d.get("climb_o"));
    EXPECT_FALSE(d.get("restart_o"));
    EXPECT_EQ(d.get("copy_sub_o"), n == 0) << "dr1 is copied once";
  }
  d.see("ack_i", 1);
  EXPECT_TRUE(d.get("climb_o"));
  EXPECT_TRUE(d.get("restart_o")) << "the stack is empty";
  d.clock();
  d.see("ack_i", 0);
  EXPECT_EQ(d.i1(), 21);
  EXPECT_FALSE(d.get("emit_o"));
}

TYPED_TEST(SubdividerOfferTest, AcceptedHitIsNotOfferedAgainWhileItClimbs) {
  auto& d = this->dut;
  d.start(20, 20);
  d.split_at(9);  // a stacked interval: no restart
  d.clock();
  d.set("tag_i", tag_of(3, 6));
  d.set("top_tag_i", tag_of(1, 6));
  d.set("top_i2_i", 20);
  d.set("wall_i", 1);
  d.see("ack_i", 1);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_TRUE(d.get("climb_o"));
  d.clock();
  d.see("ack_i", 0);
  for (int n = 0; n < 4; ++n, d.clock()) {
    EXPECT_EQ(d.state(), StateReturn);
    EXPECT_FALSE(d.get("emit_o"));
    EXPECT_TRUE(d.get("climb_o"));
  }
  d.set("tag_i", tag_of(1, 6));
  d.see("second_i", 1);
  EXPECT_TRUE(d.get("climb_o")) << "there, but half way through the room change";
  d.clock();
  d.set("wall_i", 0);
  d.see("second_i", 0);
  EXPECT_FALSE(d.get("climb_o"));
  d.clock();
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_EQ(d.i1(), 10);
  EXPECT_EQ(d.i2(), 20);
  EXPECT_EQ(d.get("sd_o"), 0);
}

// 9.8: accepted and popped in the same clock of RETURN: the first LEFT clock accepts no hit.
TYPED_TEST(SubdividerOfferTest, HitWaitsAClockAfterALateAccept) {
  auto& d = this->dut;
  d.start(3, 3);
  d.split_at(0);
  d.clock();
  d.set("top_i2_i", 1);
  d.see("wall_i", 1);
  d.clock();
  EXPECT_EQ(d.state(), StateReturn);
  d.see("ack_i", 1);
  EXPECT_TRUE(d.get("emit_o"));
  d.clock();
  d.see("ack_i", 0);
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_EQ(d.idx2(), d.i2()) << "aligned, and still a wall";
  EXPECT_FALSE(d.get("emit_o"));
  d.clock();
  EXPECT_TRUE(d.get("emit_o"));
}

// 9.3: len_m1 <= 32 is given up when the beam starves.
template <class Unit>
bool gives_up(Dut<Unit>& d, int pixels, int starving = 1) {
  d.start(pixels - 1, pixels - 1);
  d.see("starving_i", starving);
  return d.get("emit_o");
}

TYPED_TEST(SubdividerOfferTest, HurryGivesUp33PixelsButNot34) {
  auto& d = this->dut;
  EXPECT_TRUE(gives_up(d, 1));
  EXPECT_TRUE(gives_up(d, 33));
  EXPECT_FALSE(gives_up(d, 34));
  EXPECT_FALSE(gives_up(d, 640));
  EXPECT_FALSE(gives_up(d, 10, 0));
}

TYPED_TEST(SubdividerOfferTest, NoHitIsAcceptedBeforeTheRightEndIsAligned) {
  auto& d = this->dut;
  d.start(20, 10);
  d.set("starving_i", 1);
  d.see("wall_i", 1);
  EXPECT_FALSE(d.get("emit_o"));
  d.clock(2);
  EXPECT_EQ(d.idx2(), 20);
  EXPECT_TRUE(d.get("emit_o"));
}

// 9.8, 11.7: also in the second half of a room change.
TYPED_TEST(SubdividerOfferTest, HurryAcceptsInTheMiddleOfARoomChange) {
  auto& d = this->dut;
  d.start(20, 20);
  d.set("second_i", 1);
  d.see("ack_i", 1);
  EXPECT_FALSE(d.get("emit_o"));
  d.see("starving_i", 1);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_TRUE(d.get("climb_o"));
  EXPECT_EQ(d.step(), 1);
  d.clock();
  EXPECT_EQ(d.state(), StateReturn);
}

// 9.8: after the interval ending at 639 nothing is emitted, but the tracer goes on at 640.
TYPED_TEST(SubdividerOfferTest, NothingIsEmittedAfterPixel639) {
  auto& d = this->dut;
  d.start(639, 639);
  d.set("ack_i", 1);
  d.see("wall_i", 1);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_FALSE(d.get("line_done_o"));
  d.clock();
  EXPECT_TRUE(d.get("line_done_o"));
  d.see("ack_i", 0);
  EXPECT_TRUE(d.get("restart_o"));
  d.clock();
  EXPECT_EQ(d.i1(), 640);
  EXPECT_EQ(d.i2(), 639);
  EXPECT_EQ(d.get("len_m1_o"), 1023);
  int restarts = 0;
  for (int n = 0; n < 200; ++n, d.clock()) {
    EXPECT_FALSE(d.get("emit_o"));
    EXPECT_TRUE(d.get("line_done_o"));
    restarts += d.get("restart_o");
  }
  EXPECT_GT(restarts, 20) << "still running";
  d.start(639, 0);
  EXPECT_FALSE(d.get("line_done_o"));
}

TYPED_TEST(SubdividerOfferTest, IntervalNotEndingAt639DoesNotEndTheLine) {
  auto& d = this->dut;
  d.start(638, 638);
  d.set("ack_i", 1);
  d.see("wall_i", 1);
  d.clock();
  d.see("ack_i", 0);
  d.clock();
  EXPECT_FALSE(d.get("line_done_o"));
}

template <class Unit>
class SubdividerOfferKnobs : public testing::Test {};
TYPED_TEST_SUITE(SubdividerOfferKnobs, Twins);

TYPED_TEST(SubdividerOfferKnobs, HurryThresholdMinus1NeverGivesUp) {
  knobs k;
  k.hurry_threshold = -1;
  Dut<TypeParam> d(k);
  for (const int pixels : {1, 2, 33, 640}) EXPECT_FALSE(gives_up(d, pixels)) << pixels;
  d.see("wall_i", 1);
  EXPECT_TRUE(d.get("emit_o")) << "walls are still hit";
}

TYPED_TEST(SubdividerOfferKnobs, HurryThreshold639GivesUpTheWholeLine) {
  knobs k;
  k.hurry_threshold = 639;
  Dut<TypeParam> d(k);
  EXPECT_TRUE(gives_up(d, 640));
}

}  // namespace
}  // namespace racebeam
