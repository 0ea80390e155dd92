// Promises of sc/beam/navigator.h: flights through faces with several portals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "tests/beam/beside.h"
#include "tests/beam/navigator_free_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using NavigatorPortalsTest = FreeFlight<Unit, 3>;
template <class Unit>
using NavigatorFourPortalsTest = FreeFlight<Unit, 4>;
TYPED_TEST_SUITE(NavigatorPortalsTest, Twins);
TYPED_TEST_SUITE(NavigatorFourPortalsTest, Twins);

/// Clocks of a flight that finds the camera behind portal `found` of three: five, or six through a
/// face at negative coordinates; four to find it inside, but for the last portal; for each portal
/// before, three or four to find it beyond the room's + or - side, and three or four to leave anew.
int expected_clocks(int face, const std::vector<int>& order, int found) {
  const int negative = face % 2;
  int clocks = 5 + negative + (found < 2 ? 4 : 0);
  for (int p = 0; p < found; ++p) clocks += (order[found] > order[p] ? 3 : 4) + 3 + negative;
  return clocks;
}

TYPED_TEST(NavigatorPortalsTest, CameraEndsInTheRoomThatHoldsItWhicheverPortalItIs) {
  for (const std::vector<int>& order :
       {std::vector<int>{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    this->world.order = order;
    for (int face = 0; face < 6; ++face)
      for (int found = 0; found < 3; ++found) {
        SCOPED_TRACE(testing::Message() << "face " << face << ", portal " << found << ", rooms "
                                        << order[0] << order[1] << order[2]);
        const auto& span = ThreeBehindEachFace::spans[order[found]];
        for (const int at : {span.low + 1, (span.low + span.high) / 2, span.high}) {
          const int clocks = this->leave(face, at);
          ASSERT_NO_FATAL_FAILURE(this->expect_in(10 * face + order[found])) << "at " << at;
          EXPECT_EQ(this->out("nav_portal_o"), found);
          EXPECT_EQ(clocks, expected_clocks(face, order, found));
          EXPECT_LE(clocks, 6 + 9 * (found + 1)) << "header";
        }
      }
  }
}

// As with one portal, wherever the number of portals changes from face to face.
TYPED_TEST(NavigatorPortalsTest, FaceWithOnePortalIsLeftByIt) {
  this->world.order = {1};
  for (int face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    this->leave(face, 0);
    this->expect_in(10 * face + 1);
    EXPECT_EQ(this->out("nav_portal_o"), 0);
  }
}

TYPED_TEST(NavigatorPortalsTest, EveryFlightTriesFromPortal0On) {
  this->leave(4, 70);
  this->expect_in(42);
  this->leave(4, -70);
  this->expect_in(40);
  EXPECT_EQ(this->out("nav_portal_o"), 0);
  for (int& v : this->world.velocity) v = -v;
  this->fly();
  EXPECT_EQ(this->out("nav_room_o"), Hub);
}

// Reset to the very place where the camera is: the portal is forgotten all the same.
TYPED_TEST(NavigatorPortalsTest, ResetForgetsThePortal) {
  this->leave(0, 70);
  ASSERT_EQ(this->out("nav_portal_o"), 2);
  this->bench.drive("start", "_i", this->position());
  this->bench["start_room_i"].drive(this->out("nav_room_o"));
  this->bench["nav_reset_i"].drive(1);
  this->bench.clock();
  EXPECT_EQ(this->out("nav_portal_o"), 0);
}

// Reset in the midst of trying.
TYPED_TEST(NavigatorPortalsTest, ResetHasPriorityInEveryClockOfTrying) {
  for (int clocks = 0; clocks < 24; ++clocks) {
    this->place({7, 70, -97});
    this->world.velocity = {0, 0, 5};
    this->start_nav_line();
    for (int n = 0; n < clocks; ++n) this->clock();
    this->bench["nav_reset_i"].drive(1);
    this->clock();
    EXPECT_EQ(this->position(), (vec3{-7, -70, 97})) << clocks;
    EXPECT_EQ(this->out("nav_room_o"), Hub) << clocks;
    EXPECT_EQ(this->out("nav_op_o"), CornerHold) << clocks;
    EXPECT_EQ(this->out("nav_portal_o"), 0) << clocks;
  }
}

TYPED_TEST(NavigatorFourPortalsTest, NoInputIsMissedUnderRandomOnes) {
  auto& bench = this->bench;
  navigator_core core;
  const auto in = [&](const char* port) { return static_cast<int>(bench[port].value()); };
  const auto signed_in = [&](const char* stem) { return bench.read(stem, "_i"); };
  const auto reset = [&] { return !in("rst_ni") || in("nav_reset_i"); };
  const auto clock = [&] {
    core.clock({reset(), signed_in("start"), in("start_room_i"),
                in("nav_line_i") && in("active_start_i"), signed_in("corner"), in("room_i")},
               this->fitted);
  };
  const auto check = [&] {
    const auto want = core.comb(in("nav_line_i"), signed_in("corner"));
    ASSERT_EQ(this->position(), core.position_q);
    ASSERT_EQ(in("nav_room_o"), core.room_q);
    ASSERT_EQ(in("nav_portal_o"), core.portal_q);
    ASSERT_EQ(in("nav_axis_o"), want.axis);
    ASSERT_EQ(in("nav_negative_o"), want.negative);
    ASSERT_EQ(in("nav_op_o"), want.op);
    ASSERT_EQ(in("nav_move_o"), want.move);
  };
  bench["nav_reset_i"].drive(1);
  bench.settle();
  clock();
  bench.clock();
  run_beside(bench, 131, 40000, clock, check);
}

}  // namespace
}  // namespace racebeam
