// Promises of sc/beam/subdivider.h: descents, restart, reset and stack, contract section 9 and item
// S of 18.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/subdivider.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/beam/subdivider_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(SubdividerTest, Twins);

TYPED_TEST(SubdividerTest, AgreeingEndsDescendInTwoClocks) {
  auto& d = this->dut;
  d.start(300, 300);
  d.see("dec_i", 1);
  EXPECT_FALSE(d.get("descend_o"));
  d.clock();
  EXPECT_EQ(d.state(), StateRight);
  EXPECT_TRUE(d.get("descend_o"));
  EXPECT_FALSE(d.get("push_en_o"));
  EXPECT_EQ(d.get("cur_o") & 1, 1);
  d.clock();
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_EQ(d.i2(), 300);
}

// 9.2, 9.7: only the masked bits are compared and stored.
TYPED_TEST(SubdividerTest, MaskedBitsAloneDecideAndAreStored) {
  auto& d = this->dut;
  d.start(300, 300);
  d.set("mask_i", SignMask);
  d.see("dec_i", 10);
  d.clock();
  EXPECT_EQ(d.get("ray_signs_o"), 5);
  d.see("dec_i", 11);
  EXPECT_TRUE(d.get("descend_o")) << "the bit does not count";
  d.clock();
  d.set("mask_i", BitMask);
  d.see("dec_i", 1);
  d.clock();
  EXPECT_EQ(d.get("ray_signs_o"), 5) << "the signs stay";
  EXPECT_EQ(d.get("cur_o"), 11) << "stored signs and new bit";
  d.see("dec_i", 15);
  EXPECT_TRUE(d.get("descend_o")) << "the signs do not count";
}

TYPED_TEST(SubdividerTest, OnePixelDescendsInLeftWithWhatItSees) {
  auto& d = this->dut;
  d.start(0, 0);
  for (const int dec : {0, 1, 6, 15}) {
    d.see("dec_i", dec);
    EXPECT_EQ(d.state(), StateLeft);
    EXPECT_TRUE(d.get("descend_o"));
    EXPECT_EQ(d.get("cur_o"), dec);
    EXPECT_EQ(d.get("leave_o"), 0) << "not at level 7";
    d.see("tag_i", tag_of(3, 7));
    EXPECT_EQ(d.get("leave_o"), 2 | (dec & 1));
    d.see("tag_i", tag_of(3, 6));
    d.clock();
  }
}

TYPED_TEST(SubdividerTest, RoomChangeHoldsTheDecisionButNotTheAlignment) {
  auto& d = this->dut;
  d.start(20, 21);
  d.see("second_i", 1);
  EXPECT_EQ(d.step(), -1);
  d.clock(3);
  EXPECT_EQ(d.idx2(), 20);
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_FALSE(d.get("descend_o"));
  d.see("second_i", 0);
  d.clock();
  EXPECT_EQ(d.state(), StateRight);
}

// 9.7: restart takes i1 past the interval and i2 from the camera, and empties the stack.
TYPED_TEST(SubdividerTest, RestartWaitsForTheAcceptAndTakesTheCamerasEnd) {
  auto& d = this->dut;
  d.start(254, 254);
  d.set("i2_init_i", 639);
  d.set("top_i2_i", 254);
  d.see("wall_i", 1);
  d.clock();
  for (int n = 0; n < 3; ++n, d.clock()) EXPECT_FALSE(d.get("restart_o"));
  d.see("ack_i", 1);
  EXPECT_TRUE(d.get("restart_o"));
  EXPECT_FALSE(d.get("descend_o"));
  EXPECT_FALSE(d.get("push_en_o"));
  EXPECT_EQ(d.step(), 0) << "no step in the restart";
  d.clock();
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_EQ(d.i1(), 255);
  EXPECT_EQ(d.i2(), 639);
  EXPECT_EQ(d.get("sp_o"), 0);
  EXPECT_EQ(d.get("sd_o"), 0);
}

// 18, item S (frame 8754): waiting with an empty stack steps toward the stale entry, and 2^10 moves
// dr2 but not idx2.
TYPED_TEST(SubdividerTest, StaleEntryDrawsTheRightEndWhileAnOfferWaits) {
  auto& d = this->dut;
  d.start(508, 508);
  d.set("top_i2_i", 8);
  d.see("wall_i", 1);
  EXPECT_EQ(d.step(), 1);
  d.clock();
  EXPECT_EQ(d.idx2(), 509);
  EXPECT_EQ(d.step(), -512);
  d.clock();
  for (int n = 0; n < 4; ++n, d.clock()) {
    EXPECT_EQ(d.idx2(), 1021);
    EXPECT_EQ(d.step(), -1024);
  }
}

// 9.6, 9.7: the camera loads idx2 and i2, and sees `stepping` until they meet.
TYPED_TEST(SubdividerTest, TracerResetFollowsTheCamera) {
  auto& d = this->dut;
  d.start(639, 639);
  d.split_at(100);
  d.clock();
  d.set("tracer_reset_i", 1);
  d.set("i2_init_i", 96);
  d.set("wall_i", 1);
  d.see("starving_i", 1);
  EXPECT_FALSE(d.get("emit_o"));
  d.clock();
  EXPECT_EQ(d.state(), StateLeft);
  EXPECT_EQ(d.i1(), 0);
  EXPECT_EQ(d.i2(), 96);
  EXPECT_EQ(d.get("sp_o"), 0);
  EXPECT_EQ(d.get("sd_o"), 0);
  d.clock(10);
  EXPECT_EQ(d.idx2(), 96);
  EXPECT_EQ(d.step(), 0);
  d.see("i2_init_i", 16);
  d.clock();
  EXPECT_NE(d.step(), 0) << "stepping again";
  d.set("idx_load_i", 1);
  d.see("idx_start_i", 256);
  EXPECT_NE(d.step(), 0);
  d.clock();
  EXPECT_EQ(d.idx2(), 256) << "the load wins over the step";
}

// 10.1, 9.7: sp wraps, sd saturates; then as many pops as there are words, and a restart.
template <class Unit>
void expect_ring(Dut<Unit>& d, int size) {
  const int pushes = size + 3;
  d.start(639, 639);
  d.set("i2_init_i", 639);
  for (int n = 0; n < pushes; ++n) {
    ASSERT_EQ(d.get("sp_o"), n % size);
    ASSERT_EQ(d.get("sd_o"), std::min(n, size));
    d.split_at(600 - 2 * n);
    d.clock();
  }
  int end = d.i2();
  const auto hit = [&] {
    d.see("wall_i", 1);
    for (int n = 0; n < 8 && d.state() != StateReturn; ++n, d.bench.settle()) {
      d.see("ack_i", d.get("emit_o"));
      d.clock();
    }
    d.see("ack_i", 0);
    ASSERT_EQ(d.state(), StateReturn);
  };
  for (int left = size; left > 0; --left) {
    ASSERT_EQ(d.get("sd_o"), left);
    end += 2;
    d.set("top_i2_i", end);
    hit();
    EXPECT_FALSE(d.get("restart_o"));
    d.clock();
    d.see("wall_i", 0);
    ASSERT_EQ(d.i2(), end);
    ASSERT_EQ(d.get("sp_o"), (pushes + size - (size - left + 1)) % size);
  }
  hit();
  EXPECT_TRUE(d.get("restart_o"));
}

TYPED_TEST(SubdividerTest, StackCountSaturatesAndUnderflowsToARestart) {
  expect_ring(this->dut, 4);
}

template <class Unit>
class SubdividerKnobs : public testing::Test {};
TYPED_TEST_SUITE(SubdividerKnobs, Twins);

template <class Unit>
void expect_ring_of(int size) {
  knobs k;
  k.interval_stack_depth = size;
  Dut<Unit> d(k);
  expect_ring(d, size);
}

TYPED_TEST(SubdividerKnobs, RingOfOneEntry) { expect_ring_of<TypeParam>(1); }
TYPED_TEST(SubdividerKnobs, RingOfTwoEntries) { expect_ring_of<TypeParam>(2); }
TYPED_TEST(SubdividerKnobs, RingOf64Entries) { expect_ring_of<TypeParam>(64); }

}  // namespace
}  // namespace racebeam
