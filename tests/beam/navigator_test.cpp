// Promises of sc/beam/navigator.h: controls, priorities and stored bits, contract section 13.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/navigator.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/beam/navigator_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(NavigatorTest, Twins);

/// No clock and no reset yet.
template <class Unit>
class NavigatorPowerUpTest : public testing::Test {
 protected:
  static void expect_camera(const knobs& k, const vec3& position, int room) {
    Unit unit("dut", k);
    UnitBench bench(unit);
    bench.settle();
    EXPECT_EQ(bench.read("nav_position"), position);
    EXPECT_EQ(bench["nav_room_o"].value(), room);
  }
};
TYPED_TEST_SUITE(NavigatorPowerUpTest, Twins);

TYPED_TEST(NavigatorPowerUpTest, WiredBitsAreThereBeforeAnyReset) {
  this->expect_camera({}, {0, 32, 0}, 4);
}

TYPED_TEST(NavigatorPowerUpTest, NothingIsWiredInFreeFlight) {
  knobs k;
  k.free_flight = true;
  k.navigator_bits = 11;
  k.corner_bits = 14;
  this->expect_camera(k, {0, 0, 0}, 0);
}

// Contract 13: what is wired in the stored position.
TYPED_TEST(NavigatorTest, LowBitsOfXAndYAreWired) {
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n) {
    this->frame(true);
    this->bench["nav_reset_i"].drive(0);
    this->start_nav_line();
    this->clock();
    for (int& e : this->corner) e = wrap12(static_cast<int>(random() % 4096));
    const vec3 c = this->corner;
    this->clock();  // TO_PLUS stores
    EXPECT_EQ(this->position(), (vec3{wrap_signed(c[0], 9) & ~63, (wrap_signed(c[1], 9) & ~63) + 32,
                                      wrap_signed(c[2], 9)}))
        << c[0] << "," << c[1] << "," << c[2];
    for (int m = 0; m < 6; ++m) this->clock();
  }
}

TYPED_TEST(NavigatorTest, ResetHasPriorityInEveryState) {
  for (const char* reset : {"nav_reset_i", "rst_ni"})
    for (int state = 0; state < 7; ++state) {
      for (int f = 0; f < 4; ++f) this->frame(f == 0);
      ASSERT_EQ(this->position(), (vec3{0, -224, -3}));
      this->start_nav_line();
      for (int n = 0; n < state; ++n) this->clock();
      const bool level = reset[0] == 'n';
      this->bench[reset].drive(level);
      this->clock();
      EXPECT_EQ(this->position(), (vec3{0, -224, 0})) << reset << " in clock " << state;
      EXPECT_EQ(this->out("nav_op_o"), CornerHold) << reset << " in clock " << state;
      this->bench.drive("start", "_i", {0, 160, 0});
      this->clock(true);  // also over a start
      EXPECT_EQ(this->position(), (vec3{0, 160, 0}));
      EXPECT_EQ(this->out("nav_op_o"), CornerHold);
      this->bench[reset].drive(!level);
      this->bench.drive("start", "_i", {0, -224, 0});
      this->clock();
      EXPECT_EQ(this->position(), (vec3{0, 160, 0}));
    }
}

// Contract 13: the lookup in all clocks of the nav_line, whatever the state, and all transitions.
TYPED_TEST(NavigatorTest, ControlsFollowTheTableForRandomCorners) {
  enum { Idle, ToPlus, CheckPlus, CheckMinus, Finish, Store, Adjust };
  const int fixed_op[7] = {CornerHold, CornerAddS, 0, 0, CornerAddR, CornerHold, CornerAddVelocity};
  this->frame(true);
  this->bench["nav_reset_i"].drive(0);
  this->bench["nav_line_i"].drive(1);
  std::mt19937 random(7);
  int state = Idle, visits[7] = {};
  for (int n = 0; n < 5000; ++n) {
    ++visits[state];
    const bool start = random() % 8 == 0;
    this->bench["active_start_i"].drive(start);
    for (int& e : this->corner)
      e = wrap12(static_cast<int>(random() % 4 ? random() % 4096 : random() % 3 - 1));
    if (n % 3 == 0)
      for (int& e : this->corner) e = n % 2 ? -1 - (e & 2047) : e & 2047;
    this->room = static_cast<int>(random() % 512);
    this->show_corner();
    int axis = -1;
    for (int a = 2; a >= 0; --a)
      if ((this->corner[a] < 0) == (state % 2 == 0)) axis = a;
    const bool move = axis >= 0 && (state == CheckPlus || state == CheckMinus);
    int op = fixed_op[state];
    if (state == CheckPlus) op = move ? CornerLeavePlus : CornerSubtract2S;
    if (state == CheckMinus && move) op = CornerLeaveMinus;
    ASSERT_EQ(this->out("nav_op_o"), op) << "state " << state;
    ASSERT_EQ(this->out("nav_move_o"), move) << "state " << state;
    if (axis >= 0) {
      ASSERT_EQ(this->out("nav_axis_o"), axis) << "state " << state;
    }
    ASSERT_EQ(this->out("nav_negative_o"), move && state == CheckMinus) << "state " << state;
    const int room = this->room;
    this->bench.clock();
    if (state == Store) {
      ASSERT_EQ(this->out("nav_room_o"), (room & 0xf0) | 4);
    }
    static constexpr int next[7] = {Idle, CheckPlus, CheckMinus, Idle, Store, Idle, ToPlus};
    state = start ? static_cast<int>(Adjust) : move ? static_cast<int>(Finish) : next[state];
  }
  for (const int count : visits) EXPECT_GT(count, 100);
}

// Header, Comb: every corner pin reaches nav_axis_o without a clock.
TYPED_TEST(NavigatorTest, LookupFollowsEachCornerAlone) {
  this->frame(true);
  this->bench["nav_line_i"].drive(1);
  for (int a = 0; a < 3; ++a)
    for (const int other : {0, 2047}) {
      this->corner = {other, other, other};
      this->show_corner();
      this->corner[a] = -1;
      this->show_corner();
      EXPECT_EQ(this->out("nav_axis_o"), a);
      EXPECT_EQ(this->out("nav_negative_o"), 0);
    }
}

// Header, Comb: off the nav_line the lookup rests, wherever the corner is.
TYPED_TEST(NavigatorTest, OffTheNavLineTheLookupRests) {
  this->frame(true);
  for (const int nav_line : {1, 0}) {
    this->bench["nav_line_i"].drive(nav_line);
    this->corner = {5, 5, -1};
    this->show_corner();
    EXPECT_EQ(this->out("nav_axis_o"), nav_line ? 2 : 0);
    EXPECT_EQ(this->out("nav_op_o"), CornerHold);
  }
}

// Contract 13: a start needs nav_line and active_start in the same clock, in any order of arrival.
TYPED_TEST(NavigatorTest, StartNeedsNavLineAndActiveStart) {
  auto& bench = this->bench;
  this->frame(true);
  bench["nav_reset_i"].drive(0);
  const auto op_after = [&](bool nav_line, bool active_start) {
    bench["nav_line_i"].drive(nav_line);
    bench["active_start_i"].drive(active_start);
    bench.clock();
    return this->out("nav_op_o");
  };
  EXPECT_EQ(op_after(false, false), CornerHold);
  EXPECT_EQ(op_after(true, false), CornerHold);
  EXPECT_EQ(op_after(false, true), CornerHold);
  EXPECT_EQ(op_after(true, true), CornerAddVelocity);
}

}  // namespace
}  // namespace racebeam
