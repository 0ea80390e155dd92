// Promises of sc/subdivider.h: contract section 9, items S of 18 and vectors 20.2.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/subdivider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tb/unit_bench.h"

namespace racebeam {
namespace {

constexpr int SignMask = 14, BitMask = 1;

constexpr int tag_of(int depth, int level) { return depth << LevelBits | level; }

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
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) {}

  int get(const char* port) { return bench[port].value(); }
  void set(const char* port, int value) { bench[port].drive(value); }
  /// Sets an input and lets the outputs follow.
  void see(const char* port, int value) {
    set(port, value);
    bench.settle();
  }
  void clock(int edges = 1) { bench.clock(edges); }

  /// The interval 0..i2 at the top of the tree, with dr2 at pixel `at`, all other inputs 0.
  void start(int i2, int at) {
    for (auto* pin : bench.pins())
      if (pin->input) pin->drive(0);
    set("tracer_reset_i", 1);
    set("idx_load_i", 1);
    set("idx_start_i", at);
    set("i2_init_i", i2);
    set("mask_i", BitMask);
    clock();
    set("idx_load_i", 0);
    set("tracer_reset_i", 0);
    bench.settle();
  }
  int state() { return get("state_o"); }
  int idx2() { return get("idx2_o"); }
  int i2() { return get("i2_o"); }
  int i1() { return (get("i2_o") - get("len_m1_o")) & 1023; }
  /// Step on request in this clock; 0 if none.
  int step() { return get("step_o") ? (get("neg_o") ? -1 : 1) * get("step_size_o") : 0; }
  /// LEFT and RIGHT (aligned), then bisects to `last`, the last pixel with decision 0. The split
  /// ends in the clock that stays settled: push_en is 1 there. Returns the clocks in BISECT.
  int split_at(int last) {
    see("dec_i", i1() > last);
    clock();
    int clocks = 0;
    for (see("dec_i", idx2() > last); !get("push_en_o") && clocks < 700; ++clocks) {
      clock();
      see("dec_i", idx2() > last);
    }
    return clocks;
  }
};

template <class Unit>
class SubdividerTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<subdivider>;
TYPED_TEST_SUITE(SubdividerTest, Twins);

/// What stands around the unit in the trace of frame 2, y = -240: tree, rooms and both stacks.
template <class Unit>
struct Frame2 {
  Dut<Unit>& d;
  int c = 50, depth = 0, level = 2;
  bool second = false, wall = false;
  int tags[4]{}, ends[4]{};
  // Last pixel of the left branch, by place; the rooms' walls, by left pixel and place.
  const std::map<int, int> splits{{2, 318}, {6, 254}, {7, 222}, {tag_of(1, 6), 127},
                                  {15, 27}, {22, 0},  {32, 16}};
  const std::set<std::pair<int, int>> walls{
      {0, tag_of(3, 7)}, {17, tag_of(4, 7)}, {28, 15}, {128, 15}, {223, 15}};

  explicit Frame2(Dut<Unit>& d) : d(d) {
    d.start(639, 0);
    settle();
  }
  int tag() const { return tag_of(depth, level); }
  int dec(int pixel) const {
    const auto split = splits.find(tag());
    const bool right = split != splits.end() && pixel > split->second;
    if (tag() == 2) return right ? 4 : 6;  // signs z 0, y 1, x 1 or 0
    if (tag() == 32) return !right;        // 4.0: wall on the left
    return right;
  }
  void settle() {
    const int top = (d.get("sp_o") + 3) % 4;
    d.set("mask_i", tag() == 2 ? SignMask : BitMask);
    d.set("dec_i", dec(d.state() == StateLeft ? d.i1() : d.idx2()));
    d.set("tag_i", tag());
    d.set("second_i", second);
    d.set("wall_i", wall);
    d.set("top_tag_i", tags[top]);
    d.set("top_i2_i", ends[top]);
    d.bench.settle();
    d.see("ack_i", d.get("emit_o"));
  }
  void clock() {
    const int top_tag = tags[(d.get("sp_o") + 3) % 4], cur = d.get("cur_o") & 1;
    if (d.get("push_en_o")) {
      tags[d.get("sp_o")] = tag();
      ends[d.get("sp_o")] = d.i2();
    }
    const bool down = d.get("descend_o"), up = d.get("climb_o"), restart = d.get("restart_o");
    const int left = d.i1();
    if (d.state() == StateReturn) wall = false;
    d.clock();
    ++c;
    if (restart) {
      depth = 0, level = 2, second = false;
    } else if (down && level == 7) {
      if (walls.count({left, tag()})) wall = true;
      else second = true;
    } else if (second && !up) {
      second = false, ++depth, level = 0;
    } else if (down) {
      if (level < 4 && depth > 0) wall = cur;
      level = level == 2 && depth == 0 ? 6 : level == 3 ? 6 : level + 1;
    } else if (up && depth != top_tag >> LevelBits) {
      second = true, --depth, level = 7;
    } else if (up) {
      second = false, level = top_tag & 7;
    }
    settle();
  }
  /// Runs to clock `at` and checks the row of the table.
  void expect(int at, int state, int i1, int i2, int idx2, int depth_now, int level_now) {
    while (c < at) clock();
    const std::vector<int> row{d.state(), d.i1(), d.i2(), d.idx2(), depth, level};
    EXPECT_EQ(row, (std::vector<int>{state, i1, i2, idx2, depth_now, level_now})) << "c = " << c;
  }
};

// 9.9, all rows.
TYPED_TEST(SubdividerTest, TraceOfFrame2RunsAsInTheContract) {
  auto& d = this->dut;
  Frame2<TypeParam> f(d);
  const int adjusting[] = {0, 512, 640, 639};
  for (int n = 0; n < 4; ++n) f.expect(50 + n, StateLeft, 0, 639, adjusting[n], 0, 2);
  f.expect(54, StateRight, 0, 639, 639, 0, 2);
  EXPECT_EQ(d.step(), -256);
  const int halves[] = {383, 255, 319, 287, 303, 311, 315, 317, 318};
  for (int n = 0; n < 9; ++n) f.expect(55 + n, StateBisect, 0, 639, halves[n], 0, 2);
  EXPECT_TRUE(d.get("push_en_o")) << "c = 63";
  EXPECT_EQ(d.step(), 0) << "c = 63: dr2 stands on the left pixel";
  EXPECT_EQ(d.get("cur_o"), 6);
  f.expect(64, StateLeft, 0, 318, 318, 0, 6);
  EXPECT_EQ(d.get("sp_o"), 1);
  EXPECT_EQ(d.get("sd_o"), 1);
  EXPECT_EQ(d.get("signs_o"), 3);
  f.expect(73, StateBisect, 0, 318, 255, 0, 6);
  EXPECT_TRUE(d.get("push_en_o"));
  EXPECT_EQ(d.step(), -1);
  f.expect(83, StateBisect, 0, 254, 223, 0, 7);
  EXPECT_TRUE(d.get("push_en_o"));
  f.expect(84, StateLeft, 0, 222, 222, 0, 7);
  EXPECT_TRUE(f.second);
  f.expect(85, StateLeft, 0, 222, 222, 1, 0);
  f.expect(102, StateBisect, 0, 222, 127, 1, 6);
  EXPECT_TRUE(d.get("push_en_o"));
  f.expect(103, StateLeft, 0, 127, 127, 1, 7);
  EXPECT_EQ(d.get("sp_o"), 0);
  EXPECT_EQ(d.get("sd_o"), 4);
  f.expect(111, StateBisect, 0, 127, 28, 1, 7);
  f.expect(112, StateLeft, 0, 27, 27, 1, 7);
  EXPECT_EQ(d.get("sp_o"), 1);
  EXPECT_EQ(d.get("sd_o"), 4);
  f.expect(127, StateLeft, 0, 0, 0, 2, 7);
  EXPECT_TRUE(d.get("descend_o")) << "a one-pixel interval descends in LEFT";
  f.expect(135, StateLeft, 0, 0, 0, 3, 7);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_EQ(d.step(), 1);
  f.expect(136, StateReturn, 0, 0, 1, 2, 7);
  EXPECT_TRUE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), 32);
  f.expect(137, StateReturn, 0, 0, 33, 2, 6);
  EXPECT_FALSE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), -4);
  f.expect(138, StateLeft, 1, 27, 29, 2, 6);
  EXPECT_EQ(d.step(), -2);
  f.expect(139, StateLeft, 1, 27, 27, 2, 6);
  f.expect(164, StateLeft, 1, 16, 16, 4, 1);
  EXPECT_TRUE(d.get("emit_o"));
  // Return over three rooms.
  f.expect(179, StateLeft, 17, 27, 27, 4, 7);
  EXPECT_EQ(d.get("sd_o"), 3);
  f.expect(180, StateReturn, 17, 27, 28, 3, 7);
  f.expect(181, StateReturn, 17, 27, 156, 2, 7);
  f.expect(182, StateReturn, 17, 27, 124, 1, 7);
  EXPECT_TRUE(f.second);
  f.expect(183, StateReturn, 17, 27, 128, 1, 7);
  EXPECT_FALSE(f.second);
  f.expect(184, StateLeft, 28, 127, 127, 1, 7);
  f.expect(186, StateLeft, 28, 127, 127, 1, 7);
  EXPECT_TRUE(d.get("emit_o")) << "length 100, section 14";
  f.expect(194, StateLeft, 128, 222, 222, 1, 7);
  EXPECT_TRUE(d.get("emit_o")) << "length 95, section 14";
  // Underflow restart.
  f.expect(212, StateLeft, 223, 254, 254, 1, 7);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_EQ(d.get("sd_o"), 0);
  f.expect(213, StateReturn, 223, 254, 255, 0, 7);  // a stale climb, 11.8
  EXPECT_TRUE(d.get("restart_o"));
  EXPECT_TRUE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), 0);
  d.see("i2_init_i", 639);
  f.expect(214, StateLeft, 255, 639, 255, 0, 2);
  EXPECT_EQ(d.step(), 512);
  f.expect(215, StateLeft, 255, 639, 767, 0, 2);
  EXPECT_EQ(d.step(), -128);
  f.expect(216, StateLeft, 255, 639, 639, 0, 2);
  EXPECT_EQ(d.step(), 0);
}

// 9.5: ties go up forward and down backward; 2^10 is 0 for idx2 (9.6).
TYPED_TEST(SubdividerTest, StepIsTheClosestPowerOfTwoToEveryDistance) {
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
TYPED_TEST(SubdividerTest, IndexWalksAsInTheVectors) {
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
TYPED_TEST(SubdividerTest, FirstBisectionStepIsClosestToHalfOfEveryWidth) {
  auto& d = this->dut;
  for (int width = 2; width <= 1023; ++width) {
    d.start(width, width);
    d.clock();
    d.see("dec_i", 1);
    ASSERT_EQ(d.state(), StateRight);
    ASSERT_EQ(d.step(), -closest_step(width, true, 2)) << "width " << width;
  }
}

TYPED_TEST(SubdividerTest, TwoPixelsSplitInTheRightClock) {
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

TYPED_TEST(SubdividerTest, BisectionFindsEverySwitchingPixelOfALine) {
  expect_all_splits(this->dut, 639, 14);
}

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
  EXPECT_EQ(d.get("signs_o"), 5);
  d.see("dec_i", 11);
  EXPECT_TRUE(d.get("descend_o")) << "the bit does not count";
  d.clock();
  d.set("mask_i", BitMask);
  d.see("dec_i", 1);
  d.clock();
  EXPECT_EQ(d.get("signs_o"), 5) << "the signs stay";
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

TYPED_TEST(SubdividerTest, OfferIsHeldInReturnUntilAcceptedAndMadeOnce) {
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

TYPED_TEST(SubdividerTest, AcceptedHitIsNotOfferedAgainWhileItClimbs) {
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
TYPED_TEST(SubdividerTest, HitWaitsAClockAfterALateAccept) {
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

TYPED_TEST(SubdividerTest, HurryGivesUp33PixelsButNot34) {
  auto& d = this->dut;
  EXPECT_TRUE(gives_up(d, 1));
  EXPECT_TRUE(gives_up(d, 33));
  EXPECT_FALSE(gives_up(d, 34));
  EXPECT_FALSE(gives_up(d, 640));
  EXPECT_FALSE(gives_up(d, 10, 0));
}

TYPED_TEST(SubdividerTest, NoHitIsAcceptedBeforeTheRightEndIsAligned) {
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
TYPED_TEST(SubdividerTest, HurryAcceptsInTheMiddleOfARoomChange) {
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

// 9.8: after the interval ending at 639 nothing is emitted, but the tracer goes on at 640.
TYPED_TEST(SubdividerTest, NothingIsEmittedAfterPixel639) {
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

TYPED_TEST(SubdividerTest, IntervalNotEndingAt639DoesNotEndTheLine) {
  auto& d = this->dut;
  d.start(638, 638);
  d.set("ack_i", 1);
  d.see("wall_i", 1);
  d.clock();
  d.see("ack_i", 0);
  d.clock();
  EXPECT_FALSE(d.get("line_done_o"));
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

// 17.4, 9.6: one pixel forward on each consume, instead of any other step.
TYPED_TEST(SubdividerTest, LockStepsOnePixelOnEachConsume) {
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

TYPED_TEST(SubdividerTest, LockDoesNotDisturbTheCamera) {
  auto& d = this->dut;
  d.start(96, 0);
  d.set("tracer_reset_i", 1);
  d.set("consume_i", 1);
  d.see("lock_i", 1);
  EXPECT_EQ(d.step(), 128);
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

// Knobs.
void expect_ring_of(int size) {
  knobs k;
  k.interval_stack_depth = size;
  Dut<subdivider> d(k);
  expect_ring(d, size);
}

TEST(SubdividerKnobs, RingOfOneEntry) { expect_ring_of(1); }
TEST(SubdividerKnobs, RingOfTwoEntries) { expect_ring_of(2); }
TEST(SubdividerKnobs, RingOf64Entries) { expect_ring_of(64); }

TEST(SubdividerKnobs, HurryThresholdMinus1NeverGivesUp) {
  knobs k;
  k.hurry_threshold = -1;
  Dut<subdivider> d(k);
  for (const int pixels : {1, 2, 33, 640}) EXPECT_FALSE(gives_up(d, pixels)) << pixels;
  d.see("wall_i", 1);
  EXPECT_TRUE(d.get("emit_o")) << "walls are still hit";
}

TEST(SubdividerKnobs, HurryThreshold639GivesUpTheWholeLine) {
  knobs k;
  k.hurry_threshold = 639;
  Dut<subdivider> d(k);
  EXPECT_TRUE(gives_up(d, 640));
}

// Halving 639 leaves one pixel after 10 clocks, the first of them RIGHT.
TEST(SubdividerKnobs, MidpointBisectionFindsEveryPixelInTenClocks) {
  knobs k;
  k.bisection = BisectionMidpoint;
  Dut<subdivider> d(k);
  expect_all_splits(d, 639, 10);
}

}  // namespace
}  // namespace racebeam
