// Promises of sc/beam/decision_datapath.h: several portals in a face.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/decision_datapath_walk.h"

namespace racebeam {
namespace {

knobs with_portals(int number) {
  knobs k;
  k.portals_per_face = number;
  return k;
}

template <class Unit>
class DecisionDatapathPortalsTest : public testing::Test {
 protected:
  /// Through +x out of room 4 at the origin into room 5, the first of three beside each other.
  void enter() {
    dut.scene = [](int room) {
      if (room == 4) return Box{{0, 0, 0}, {128, 256, 128}};
      return Box{{256, 0, (room - 6) * 80}, {128, 100 + room, 30 + room}};
    };
    dut.start({10, -20, 30}, 4);
    dut.descend(0, false);
    dut.descend(0, false);
    dut.descend(0, true, 5, 2);
    dut.clock();
    p.camera = {-10, 20, -30};
    p.rooms = {4, 5}, p.faces = {0, 0}, p.doms = {0, 0}, p.level = 0;
  }
  void expect_at(int portal, int level, int room) {
    p.rooms[1] = room, p.level = level;
    EXPECT_EQ(dut.get("tag_o"), tag_of(1, level, portal));
    EXPECT_FALSE(dut.get("second_o"));
    EXPECT_EQ(dut.get("room_o"), room);
    EXPECT_EQ(dut.corner(), p.corner(dut.scene));
    EXPECT_FALSE(dut.get("wall_o"));
  }
  void expect_look(int axis, int signs, int portal, int way) {
    EXPECT_EQ(dut.get("look_axis_o"), axis);
    EXPECT_EQ(dut.get("look_signs_o"), signs);
    EXPECT_EQ(dut.get("look_portal_o"), portal);
    EXPECT_EQ(dut.get("look_way_o"), way);
  }
  void half_way(int portal, int room) {
    EXPECT_EQ(dut.get("tag_o"), tag_of(1, 0, portal));
    EXPECT_EQ(dut.get("second_o"), 1);
    EXPECT_EQ(dut.get("room_o"), room);
    EXPECT_EQ(dut.corner(), p.at_camera());
  }

  Dut<Unit> dut{with_portals(4)};
  Place p;
};
TYPED_TEST_SUITE(DecisionDatapathPortalsTest, Twins);

TYPED_TEST(DecisionDatapathPortalsTest, RayPastAnEdgeGoesToTheNextPortalInTwoClocks) {
  auto& d = this->dut;
  for (int level = 0; level < 4; ++level) {
    SCOPED_TRACE(level);
    this->enter();
    for (int l = 0; l < level; ++l) d.descend(0, false, 77, 3);
    this->expect_at(0, level, 5);
    d.ask_descend(0, true, 6, 1);
    this->expect_look(0, 7, 2, LookNext);
    EXPECT_FALSE(d.get("fwrite_o"));
    d.clock();
    this->half_way(1, 6);
    d.clock();
    this->expect_at(1, 0, 6);
    d.descend(0, false, 77, 3);
    d.ask_descend(0, true, 7, 0);
    this->expect_look(0, 7, 1, LookNext);
    d.clock();
    this->half_way(2, 7);
    d.clock();
    this->expect_at(2, 0, 7);
    d.ask_descend(0, true, SolidRoom, 3);
    this->expect_look(0, 7, 0, LookNext);
    d.clock();
    EXPECT_TRUE(d.get("wall_o")) << "after the last portal";
    EXPECT_EQ(d.get("hit_face_o"), 0);
    EXPECT_EQ(d.get("room_o"), 7);
    EXPECT_FALSE(d.get("second_o"));
  }
}

TYPED_TEST(DecisionDatapathPortalsTest, RayWithinAllEdgesStaysWhateverTheSceneAnswers) {
  auto& d = this->dut;
  this->enter();
  for (const int level : {0, 1, 2, 3, 6}) {
    this->expect_at(0, level, 5);
    d.descend(0, false, 6, 1);
  }
  this->expect_at(0, 7, 5);
}

// The second room's number and the way back from it are what the face stack gets.
TYPED_TEST(DecisionDatapathPortalsTest, FaceStackKeepsBothPortals) {
  auto& d = this->dut;
  this->enter();
  d.descend(0, true, 6, 3);
  d.clock();
  for (int n = 0; n < 5; ++n) d.descend(0, false);
  ASSERT_EQ(d.get("tag_o"), tag_of(1, 7, 1));
  d.ask_descend(0, false, 9, 1);
  this->expect_look(2, 0, 0, LookThrough);
  EXPECT_TRUE(d.get("fwrite_o"));
  const int word = d.get("fdata_o");
  EXPECT_EQ(word, 3 << 4 | 1 << 2 | 0) << "{back, portal, face or dom}";
  d.clock();
  d.clock();
  EXPECT_EQ(d.get("tag_o"), tag_of(2, 0));
  d.ask_climb(tag_of(1, 2), 0, word, 6, StateReturn, 2);
  this->expect_look(2, 7, 1, LookThrough);
  d.clock();
  EXPECT_EQ(d.get("tag_o"), tag_of(1, 7, 1));
  d.ask_climb(tag_of(1, 2), 0, 0, 5, StateReturn, 2);
  this->expect_look(0, 7, 3, LookPrevious);
  d.clock();
  this->half_way(0, 5);
  d.climb(tag_of(1, 2), 0);
  this->expect_at(0, 2, 5);
  d.ask_descend(0, true, 6, 3);
  this->expect_look(0, 7, 2, LookNext);
}

// Header, Comb: with several portals top_tag_i and nav_portal_i reach the lookup without a clock.
TYPED_TEST(DecisionDatapathPortalsTest, LookupFollowsTheTargetAndTheNavigatorAlone) {
  auto& d = this->dut;
  this->enter();
  d.descend(0, true, 6, 3);
  d.clock();
  d.ask_climb(tag_of(1, 2, 0), 0, 0, 5);
  this->expect_look(0, 7, 3, LookPrevious);
  const auto see = [&](const char* port, int value) {
    d.set(port, value);
    d.bench.settle();
  };
  see("top_tag_i", tag_of(0, 6, 0));
  this->expect_look(0, 7, 3, LookThrough);
  see("top_tag_i", tag_of(1, 0, 1));
  this->expect_look(0, 7, 3, LookThrough);
  see("top_tag_i", tag_of(1, 0, 0));
  this->expect_look(0, 7, 3, LookPrevious);
  d.set("nav_axis_i", 2);
  d.set("nav_portal_i", 1);
  see("nav_line_i", 1);
  this->expect_look(2, 0, 1, LookThrough);
  see("nav_portal_i", 3);
  this->expect_look(2, 0, 3, LookThrough);
}

// The navigator tries another portal: the corner is the camera again, in its old room.
TYPED_TEST(DecisionDatapathPortalsTest, NavLineOperationPutsTheCameraBack) {
  auto& d = this->dut;
  d.start({10, -20, 30}, 4);
  d.set("nav_line_i", 1);
  d.set("nav_op_i", CornerLeavePlus);
  d.set("nav_move_i", 1);
  d.set("neighbour_i", 5);
  d.clock();
  EXPECT_EQ(d.get("room_o"), 5);
  d.set("nav_op_i", CornerCamera);
  d.set("nav_move_i", 0);
  d.bench.drive("nav_position", "_i", {11, -21, 31});
  d.clock();
  EXPECT_EQ(d.get("room_o"), 4);
  EXPECT_EQ(d.corner(), (vec3{11, -21, 31}));
}

template <class Unit>
void expect_restart(Dut<Unit>& d, const char* cause) {
  d.set(cause, 1);
  d.clock();
  EXPECT_EQ(d.get("tag_o"), tag_of(0, 2)) << cause;
  EXPECT_EQ(d.get("second_o"), 0) << cause;
  EXPECT_EQ(d.get("fdata_o") >> FaceBits, 0) << cause;
}

TYPED_TEST(DecisionDatapathPortalsTest, RestartAndResetForgetThePortals) {
  for (const char* cause : {"restart_i", "tracer_reset_i"})
    for (const int clocks : {1, 2}) {  // half way, and there
      this->enter();
      this->dut.descend(0, true, 6, 3);
      if (clocks == 2) this->dut.clock();
      expect_restart(this->dut, cause);
    }
}

// Descents past portals and returns to any place on the way, by geometry.
TYPED_TEST(DecisionDatapathPortalsTest, CornerIsWhereGeometryPutsItOnRandomWalks) {
  constexpr unsigned Seed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  Walk<TypeParam> walk(this->dut, 8, Seed, MaxPortals);
  walk.run(600);
  EXPECT_GT(walk.moves_beside, 1000);
  EXPECT_GT(walk.last_edges, 1000);
  EXPECT_GE(walk.deepest, 7);
  for (const int depth : {0, 1})
    for (const int portal : {0, 1}) EXPECT_GT(walk.climbs[depth][portal], 100) << depth << portal;
}

template <class Unit>
class DecisionDatapathOnePortal : public testing::Test {};
TYPED_TEST_SUITE(DecisionDatapathOnePortal, Twins);

// With one portal in each face the decision at an edge is the wall, whatever the scene answers.
TYPED_TEST(DecisionDatapathOnePortal, RayPastAnEdgeHitsTheWall) {
  Dut<TypeParam> d(with_portals(1));
  for (int level = 0; level < 4; ++level)
    for (const int neighbour : {6, 0, SolidRoom})
      for (const int leave : {0, 3}) {
        d.start({0, 0, 0}, 4);
        go_down(d, 0);
        d.descend(0, true, 5);
        d.clock();
        for (int l = 0; l < level; ++l) d.descend(0, false, 7, 1);
        d.ask_descend(0, true, neighbour, 1);
        d.set("leave_i", leave);
        d.clock();
        EXPECT_TRUE(d.get("wall_o")) << level;
        EXPECT_FALSE(d.get("second_o")) << level;
        EXPECT_EQ(d.get("room_o"), 5) << level;
        EXPECT_EQ(d.portal(), 0) << level;
      }
}

}  // namespace
}  // namespace racebeam
