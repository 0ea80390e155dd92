// Promises of sc/beam/navigator.h: flights through the rooms, contract sections 13 and 17.6.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/navigator_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using NavigatorFlightTest = NavigatorTest<Unit>;
TYPED_TEST_SUITE(NavigatorFlightTest, Twins);

// Contract 13, micro-trace of frame 129.
TYPED_TEST(NavigatorFlightTest, RoomChangeFollowsTheMicroTrace) {
  for (int f = 0; f < 129; ++f) this->frame(f == 0);
  EXPECT_EQ(this->position(), (vec3{0, -224, -128}));
  const auto row = [&](int op, vec3 corner, int room) {
    EXPECT_EQ(this->out("nav_op_o"), op);
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
  EXPECT_EQ(this->out("nav_move_o"), 1);
  EXPECT_EQ(this->out("nav_axis_o"), 2);
  EXPECT_EQ(this->out("nav_negative_o"), 0);
  this->clock();
  row(CornerAddR, {-1024, -224, -129}, 0x14);
  EXPECT_EQ(this->out("nav_move_o"), 0);
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
TYPED_TEST(NavigatorFlightTest, CameraPathOfTheFirst2048Frames) {
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
TYPED_TEST(NavigatorFlightTest, TunnelFlightBendsAndGoesRound) {
  this->world = {true, false, 160, {}};
  this->fly(2300, -2);
}

TYPED_TEST(NavigatorFlightTest, NarrowTunnelFlightChangesRoomsAtUnevenSteps) {
  this->world = {true, true, 160, {}};
  this->fly(2300, -2);
}

TYPED_TEST(NavigatorFlightTest, NarrowRoomsFlightKeepsItsHeight) {
  this->world = {false, true, 32, {}};
  this->fly(2048, -1);
}

// Contract 13: "only one room change per frame", of the lowest axis.
TYPED_TEST(NavigatorFlightTest, LowestAxisThatLeftTheBoxMoves) {
  this->frame(true);
  this->world.velocity = {-200, 0, -200};
  this->bench["nav_reset_i"].drive(0);
  this->start_nav_line();
  this->clock();
  this->clock();
  EXPECT_EQ(this->out("nav_move_o"), 1);
  EXPECT_EQ(this->out("nav_axis_o"), 0);
  for (int n = 0; n < 5; ++n) this->clock();
  EXPECT_EQ(this->room, 5);  // the x neighbour only
}

// Contract 13: CHECK_MINUS, here flown backwards from room j = 1 to j = 0.
TYPED_TEST(NavigatorFlightTest, BackwardFlightMovesToTheNegativeSide) {
  for (int f = 0; f < 140; ++f) this->frame(f == 0);
  ASSERT_EQ(this->room_j(), 1);
  ASSERT_EQ(this->position(), (vec3{0, -224, 117}));
  this->world.velocity = {0, 0, 11};  // to the wall itself: corner 0 is not negative
  this->start_nav_line();
  const int ops[] = {CornerAddVelocity, CornerAddS, CornerSubtract2S, CornerLeaveMinus,
                     CornerAddR,        CornerHold, CornerHold};
  for (const int op : ops) {
    EXPECT_EQ(this->out("nav_op_o"), op);
    EXPECT_EQ(this->out("nav_move_o"), op == CornerLeaveMinus);
    EXPECT_EQ(this->out("nav_negative_o"), op == CornerLeaveMinus);
    this->clock();
  }
  EXPECT_EQ(this->position(), (vec3{0, -224, -128}));
  EXPECT_EQ(this->room_j(), 0);
}

}  // namespace
}  // namespace racebeam
