// Promises of sc/beam/navigator.h: flights of scene files, with whole coordinates and rooms.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "tests/beam/navigator_free_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using NavigatorFreeFlightTest = FreeFlight<Unit, 1>;
TYPED_TEST_SUITE(NavigatorFreeFlightTest, Twins);

TYPED_TEST(NavigatorFreeFlightTest, WholeCoordinatesAndRoomsAreStored) {
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n) {
    this->place({0, 0, 0});
    this->start_nav_line();
    this->clock();
    for (int& e : this->corner) e = static_cast<int>(random() % 16384) - 8192;
    const vec3 c = this->corner;
    this->clock();  // TO_PLUS stores the coordinates
    for (int a = 0; a < 3; ++a) ASSERT_EQ(this->position()[a], wrap_signed(c[a], 11));
    this->corner = {-1, -1, -1};
    this->clock();
    const int room = static_cast<int>(random() % 8192);
    this->room = room;
    this->clock();
    this->room = room;
    this->clock();  // STORE the room
    ASSERT_EQ(this->out("nav_room_o"), room);
    for (int m = 0; m < 4; ++m) this->clock();
  }
}

TYPED_TEST(NavigatorFreeFlightTest, StartIsTakenWhole) {
  for (const int room : {0, 4, 4095, 8190}) {
    this->bench.drive("start", "_i", {1 - room % 1000, 1023, -1024});
    this->bench["start_room_i"].drive(room);
    this->bench["nav_reset_i"].drive(1);
    this->bench.clock();
    this->bench["nav_reset_i"].drive(0);
    this->bench.clock();
    EXPECT_EQ(this->position(), (vec3{1 - room % 1000, 1023, -1024}));
    EXPECT_EQ(this->out("nav_room_o"), room);
  }
}

TYPED_TEST(NavigatorFreeFlightTest, CameraStaysInItsRoomUpToTheFarFaces) {
  this->world.velocity = {-1, 1, -1};
  this->place({99, -98, 99});
  EXPECT_EQ(this->fly(), 3) << "add, compare with both sides";
  EXPECT_EQ(this->position(), (vec3{-100, 99, -100}));
  EXPECT_EQ(this->out("nav_room_o"), Hub);
}

// Seven units of the way are beyond the face: the new room counts from its own centre.
TYPED_TEST(NavigatorFreeFlightTest, CrossesEveryFaceIntoTheRoomBehind) {
  this->world.order = {1};
  for (int face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    EXPECT_EQ(this->leave(face, 3), face % 2 ? 6 : 5);
    this->expect_in(10 * face + 1);
    const int axis = face / 2, beyond = face % 2 ? -102 + 130 : 102 - 130;
    EXPECT_EQ(this->position()[axis], -beyond);
  }
}

// There and back again: each flight ends where it began.
TYPED_TEST(NavigatorFreeFlightTest, FliesBackThroughEveryFace) {
  this->world.order = {1};
  for (int face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    this->leave(face, 3);
    for (int& v : this->world.velocity) v = -v;
    EXPECT_EQ(this->fly(), face % 2 ? 5 : 6);
    EXPECT_EQ(this->position(), this->start);
    EXPECT_EQ(this->out("nav_room_o"), Hub);
  }
}

// Without the knob, portal 0 is taken whether or not the camera is there.
TYPED_TEST(NavigatorFreeFlightTest, OnePortalIsNeitherTestedNorFollowedByAnother) {
  for (int face = 0; face < 6; ++face)
    for (const int at : {-70, 0, 70}) {
      SCOPED_TRACE(testing::Message() << "face " << face << ", at " << at);
      EXPECT_EQ(this->leave(face, at), face % 2 ? 6 : 5);
      this->expect_in(10 * face);
      EXPECT_EQ(this->out("nav_portal_o"), 0);
    }
}

}  // namespace
}  // namespace racebeam
