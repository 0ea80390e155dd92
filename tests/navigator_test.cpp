// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/navigator.h"

#include <gtest/gtest.h>

#include <random>

#include "tb/unit_bench.h"

namespace racebeam {
namespace {

constexpr int TX[8] = {0, -2, -3, -2, 0, 2, 3, 2};
constexpr int TY[8] = {3, 2, 0, -2, -3, -2, 0, 2};

constexpr int wrap12(int v) { return (v % 4096 + 4096 + 2048) % 4096 - 2048; }
constexpr int mod(int v, int size) { return (v % size + size) % size; }

/// The rooms that a flight passes (contract 17.2; k = 0, i = 4 unless an x face is passed).
struct World {
  bool tunnel = false, narrow = false;
  int start_y = -224;
  vec3 velocity{0, 0, -1};

  int half_z(int j) const { return narrow ? (j % 2 ? 176 : 80) : 128; }
  vec3 half_size(int room) const {
    return {tunnel ? 256 : narrow ? 80 : 128, 256, half_z(room >> 4 & 15)};
  }
  vec3 position(int room) const {
    const int i = room & 15, j = room >> 4 & 15;
    if (tunnel) return {64 * TX[j % 8], 64 * TY[j % 8], 256 * j};
    return {256 * i, 0, 256 * j};
  }
  int neighbour(int room, int axis, bool negative) const {
    const int d = negative ? -1 : 1;
    if (axis == 0) return (room & ~15) | mod(room + d, 16);
    if (axis == 2) return (room & 15) | mod((room >> 4) + d, 16) << 4;
    return 511;
  }
};

template <class Unit>
class NavigatorTest : public testing::Test {
 protected:
  NavigatorTest() {
    bench.clock(2);
    bench["rst_ni"].drive(1);
    bench["start_y_i"].drive(world.start_y);
    bench.settle();
  }

  vec3 position() { return bench.read("position"); }
  int room_j() { return out("nav_room_o") >> 4 & 15; }
  int out(const char* name) { return bench[name].value(); }

  void show_corner() {
    bench.drive("corner", "_i", corner);
    bench["room_i"].drive(room);
    bench.settle();
  }

  /// One clock of the nav_line: what decision_datapath does with the navigator's controls.
  void clock(bool active_start = false) {
    bench["active_start_i"].drive(active_start);
    show_corner();
    const vec3 s = world.half_size(room), r = world.position(room);
    const int op = out("op_o");
    vec3 next = corner;
    for (int a = 0; a < 3; ++a) {
      switch (op) {
        case CornerAddVelocity: next[a] += world.velocity[a]; break;
        case CornerAddS: next[a] += s[a]; break;
        case CornerSubtract2S: next[a] -= 2 * s[a]; break;
        case CornerLeavePlus: next[a] -= r[a] + s[a]; break;
        case CornerLeaveMinus: next[a] += s[a] - r[a]; break;
        case CornerAddR: next[a] += r[a]; break;
        default: break;
      }
      next[a] = wrap12(next[a]);
    }
    if (out("move_o")) room = world.neighbour(room, out("axis_o"), out("negative_o"));
    if (active_start) {  // the tree is re-rooted (contract 11.1)
      next = position();
      room = out("nav_room_o");
    }
    bench.clock();
    corner = next;
    bench["active_start_i"].drive(0);
    show_corner();
  }

  /// Up to the first clock after active_start of the last line of a frame (c = 320).
  void start_nav_line() {
    bench["nav_line_i"].drive(1);
    clock();
    clock(true);
  }

  void frame(bool nav_reset) {
    bench["nav_reset_i"].drive(nav_reset);
    bench.clock(2);
    bench["active_start_i"].drive(1);  // of the other lines
    bench.clock();
    bench["active_start_i"].drive(0);
    bench.clock(2);
    start_nav_line();
    for (int n = 0; n < 8; ++n) clock();
    bench["nav_line_i"].drive(0);
    bench.clock();
  }

  /// A flight of `frames` frames against contract 17.6 (13.1 for the pillars).
  void fly(int frames, int velocity_z) {
    world.velocity = {0, 0, velocity_z};
    bench["start_y_i"].drive(world.start_y);
    int j = 0;  // counts on, where the tunnel's room number wraps
    for (int h = 0; h < frames; ++h) {
      if (h == 0) {
        bench["nav_reset_i"].drive(1);
        bench.clock();
      }
      const int g = h == 0 ? 0 : -velocity_z * (h - 1);
      if (256 * j - g < -world.half_z(j)) ++j;
      const int x = world.tunnel ? 64 * (TX[j % 8] - TX[0]) : 0;
      const int y = world.start_y + (world.tunnel ? 64 * (TY[j % 8] - TY[0]) : 0);
      ASSERT_EQ(position(), (vec3{x, y, 256 * j - g})) << "frame " << h;
      ASSERT_EQ(out("nav_room_o"), j % 16 << 4 | 4) << "frame " << h;
      frame(h == 0);
    }
  }

  World world;
  vec3 corner{};
  int room = 4;
  Unit unit{"dut", knobs{}};
  UnitBench bench{unit};
};

using Twins = testing::Types<navigator>;
TYPED_TEST_SUITE(NavigatorTest, Twins);

// Contract 13, micro-trace of frame 129.
TYPED_TEST(NavigatorTest, RoomChangeFollowsTheMicroTrace) {
  for (int f = 0; f < 129; ++f) this->frame(f == 0);
  EXPECT_EQ(this->position(), (vec3{0, -224, -128}));
  const auto row = [&](int op, vec3 corner, int room) {
    EXPECT_EQ(this->out("op_o"), op);
    EXPECT_EQ(this->corner, corner);
    EXPECT_EQ(this->room, room);
  };
  this->start_nav_line();
  row(CornerAddVelocity, {0, -224, -128}, 0x04);  // c = 320
  this->clock();
  row(CornerAddS, {0, -224, -129}, 0x04);
  EXPECT_EQ(this->position(), (vec3{0, -224, -128}));
  this->clock();
  row(CornerLeavePlus, {128, 32, -1}, 0x04);
  EXPECT_EQ(this->position(), (vec3{0, -224, -129}));
  EXPECT_EQ(this->out("move_o"), 1);
  EXPECT_EQ(this->out("axis_o"), 2);
  EXPECT_EQ(this->out("negative_o"), 0);
  this->clock();
  row(CornerAddR, {-1024, -224, -129}, 0x14);
  EXPECT_EQ(this->out("move_o"), 0);
  this->clock();
  row(CornerHold, {0, -224, 127}, 0x14);
  EXPECT_EQ(this->room_j(), 0);
  EXPECT_EQ(this->position(), (vec3{0, -224, -129}));
  this->clock();
  row(CornerHold, {0, -224, 127}, 0x14);  // c = 325
  EXPECT_EQ(this->position(), (vec3{0, -224, 127}));
  EXPECT_EQ(this->room_j(), 1);
}

// Contract 13.1: the table and the formula.
TYPED_TEST(NavigatorTest, CameraPathOfTheFirst2048Frames) {
  for (int f = 0; f < 2048; ++f) {
    if (f == 0) {
      this->bench["nav_reset_i"].drive(1);
      this->bench.clock();
    }
    const int g = f == 0 ? 0 : f - 1, j = (g + 127) / 256;
    ASSERT_EQ(this->position(), (vec3{0, -224, 256 * j - g})) << "frame " << f;
    ASSERT_EQ(this->out("nav_room_o"), j << 4 | 4) << "frame " << f;
    this->frame(f == 0);
  }
  EXPECT_EQ(this->room_j(), 8);
}

// Contract 17.6. The flights of the tunnels pass all 16 rooms and go round.
TYPED_TEST(NavigatorTest, TunnelFlightBendsAndGoesRound) {
  this->world = {true, false, 160, {}};
  this->fly(2300, -2);
}
TYPED_TEST(NavigatorTest, NarrowTunnelFlightChangesRoomsAtUnevenSteps) {
  this->world = {true, true, 160, {}};
  this->fly(2300, -2);
}
TYPED_TEST(NavigatorTest, NarrowRoomsFlightKeepsItsHeight) {
  this->world = {false, true, 32, {}};
  this->fly(2048, -1);
}

// Contract 13: "only one room change per frame", of the lowest axis.
TYPED_TEST(NavigatorTest, LowestAxisThatLeftTheBoxMoves) {
  this->frame(true);
  this->world.velocity = {-200, 0, -200};
  this->bench["nav_reset_i"].drive(0);
  this->start_nav_line();
  this->clock();
  this->clock();
  EXPECT_EQ(this->out("move_o"), 1);
  EXPECT_EQ(this->out("axis_o"), 0);
  for (int n = 0; n < 5; ++n) this->clock();
  EXPECT_EQ(this->room, 5);  // the x neighbour only
}

// Contract 13: CHECK_MINUS, here flown backwards from room j = 1 to j = 0.
TYPED_TEST(NavigatorTest, BackwardFlightMovesToTheNegativeSide) {
  for (int f = 0; f < 140; ++f) this->frame(f == 0);
  ASSERT_EQ(this->room_j(), 1);
  ASSERT_EQ(this->position(), (vec3{0, -224, 117}));
  this->world.velocity = {0, 0, 11};  // to the wall itself: corner 0 is not negative
  this->start_nav_line();
  const int ops[] = {CornerAddVelocity, CornerAddS, CornerSubtract2S, CornerLeaveMinus,
                     CornerAddR,        CornerHold, CornerHold};
  for (const int op : ops) {
    EXPECT_EQ(this->out("op_o"), op);
    EXPECT_EQ(this->out("move_o"), op == CornerLeaveMinus);
    EXPECT_EQ(this->out("negative_o"), op == CornerLeaveMinus);
    this->clock();
  }
  EXPECT_EQ(this->position(), (vec3{0, -224, -128}));
  EXPECT_EQ(this->room_j(), 0);
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
      EXPECT_EQ(this->out("op_o"), CornerHold) << reset << " in clock " << state;
      this->bench["start_y_i"].drive(160);
      this->clock(true);  // also over a start
      EXPECT_EQ(this->position(), (vec3{0, 160, 0}));
      EXPECT_EQ(this->out("op_o"), CornerHold);
      this->bench[reset].drive(!level);
      this->bench["start_y_i"].drive(-224);
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
    ASSERT_EQ(this->out("op_o"), op) << "state " << state;
    ASSERT_EQ(this->out("move_o"), move) << "state " << state;
    if (axis >= 0) {
      ASSERT_EQ(this->out("axis_o"), axis) << "state " << state;
    }
    ASSERT_EQ(this->out("negative_o"), move && state == CheckMinus) << "state " << state;
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

// Header, Comb: every corner pin reaches axis_o without a clock.
TYPED_TEST(NavigatorTest, LookupFollowsEachCornerAlone) {
  this->frame(true);
  this->bench["nav_line_i"].drive(1);
  for (int a = 0; a < 3; ++a)
    for (const int other : {0, 2047}) {
      this->corner = {other, other, other};
      this->show_corner();
      this->corner[a] = -1;
      this->show_corner();
      EXPECT_EQ(this->out("axis_o"), a);
      EXPECT_EQ(this->out("negative_o"), 0);
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
    return this->out("op_o");
  };
  EXPECT_EQ(op_after(false, false), CornerHold);
  EXPECT_EQ(op_after(true, false), CornerHold);
  EXPECT_EQ(op_after(false, true), CornerHold);
  EXPECT_EQ(op_after(true, true), CornerAddVelocity);
}

}  // namespace
}  // namespace racebeam
