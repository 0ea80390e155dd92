// Promises of sc/beam/decision_datapath.h: the way through the rooms, contract section 11.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/decision_datapath.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(DecisionDatapathTest, Twins);

// 11.10: frame 2, y = -240.
TYPED_TEST(DecisionDatapathTest, TraceOfFrame2MovesTheCornerAsInTheContract) {
  auto& d = this->dut;
  constexpr int Signs = 3;
  d.scene = pillars;
  d.set("y_i", -240);
  d.set("scene_interlace_i", 1);
  d.start({0, -224, -1}, room_of(4, 0, 0));
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, -1}));
  EXPECT_EQ(d.get("mask_o"), 14);
  d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{0, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{128, 480, 127})) << "c = 64";
  EXPECT_EQ(d.get("mask_o"), 1);
  d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{0, 7, 0}));
  d.ask_descend(Signs, true, room_of(3, 0, 0));
  EXPECT_EQ(d.get("look_axis_o"), 0);
  EXPECT_EQ(d.get("look_signs_o"), Signs);
  EXPECT_TRUE(d.get("fwrite_o"));
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 1}));
  EXPECT_EQ(d.corner(), (vec3{1024, 224, -1})) << "c = 84";
  EXPECT_EQ(d.get("room_o"), room_of(3, 0, 0));
  d.clock();
  const vec3 corners[] = {{128, 480, 127}, {128, 480, 127}, {128, -32, -129}, {128, -32, -129}};
  for (int level = 0; level < 4; ++level) {
    EXPECT_EQ(d.place(), (At{1, level, 0}));
    EXPECT_EQ(d.corner(), corners[level]) << "1." << level;
    d.descend(Signs, false);
  }
  EXPECT_EQ(d.place(), (At{1, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{384, 480, 127})) << "c = 93";
  // On to 2,0,0 through x and to 2,1,0 through z.
  d.descend(Signs, false);
  d.descend(Signs, true, room_of(2, 0, 0));
  for (int n = 0; n < 6; ++n) d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{2, 7, 0})) << "the clock of second counts as a descent too";
  d.ask_descend(Signs, false, room_of(2, 1, 0));
  EXPECT_EQ(d.get("look_axis_o"), 2);
  EXPECT_EQ(d.get("fdata_o"), 0) << "face 0, dom 0";
  d.clock();
  for (int n = 0; n < 6; ++n) d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{3, 7, 0}));
  EXPECT_EQ(d.corner(), (vec3{640, 480, 383})) << "c = 134";
  EXPECT_FALSE(d.get("wall_o"));
  d.descend(Signs, true, SolidRoom);
  EXPECT_TRUE(d.get("wall_o"));
  EXPECT_EQ(d.get("hit_face_o"), 0) << "x wall, index 3";
  EXPECT_EQ(d.place(), (At{3, 7, 0}));
  d.ask_climb(tag_of(2, 6), Signs, 0, room_of(2, 0, 0), StateLeft);
  EXPECT_EQ(d.get("look_axis_o"), 2) << "back through z";
  EXPECT_EQ(d.get("look_signs_o"), 4);
  d.clock();
  EXPECT_EQ(d.place(), (At{2, 7, 1}));
  EXPECT_EQ(d.corner(), (vec3{1024, 224, -1})) << "c = 136";
  EXPECT_EQ(d.get("room_o"), room_of(2, 0, 0));
  EXPECT_TRUE(d.get("wall_o")) << "cleared by RETURN";
  d.climb(tag_of(2, 6), Signs);
  EXPECT_EQ(d.place(), (At{2, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{640, 480, 127})) << "c = 137";
  EXPECT_FALSE(d.get("wall_o"));
}

// 11.5, 11.7
TYPED_TEST(DecisionDatapathTest, WallAtDepth8ShowsAClockBeforeDepth9) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  go_down(d, 7);
  d.descend(0, false, 5);
  EXPECT_FALSE(d.get("wall_o"));
  go_down(d, 8);
  EXPECT_FALSE(d.get("wall_o"));
  d.descend(0, true, 5);
  EXPECT_TRUE(d.get("wall_o"));
  EXPECT_EQ(d.place(), (At{8, 7, 1}));
  EXPECT_EQ(d.get("hit_face_o"), 0) << "the new face";
  d.ask_climb(tag_of(3, 6), 0, 0, 6, StateLeft);  // the hit is accepted in this clock
  d.clock();
  EXPECT_EQ(d.place(), (At{9, 0, 0})) << "the descent completes, the climb is ignored";
  EXPECT_EQ(d.get("room_o"), 5);
  EXPECT_TRUE(d.get("wall_o"));
  d.climb(tag_of(3, 6), 0, 0, 6);
  EXPECT_EQ(d.place(), (At{8, 7, 1}));
  EXPECT_FALSE(d.get("wall_o"));
}

// 11.8
TYPED_TEST(DecisionDatapathTest, StaleClimbFromTheRootRunsToDepth15AndTheRestartUndoesIt) {
  auto& d = this->dut;
  d.start({0, -224, -5}, 4);
  go_down(d, 0);
  d.climb(tag_of(4, 0), 0, 0, 7, StateLeft);
  EXPECT_EQ(d.place(), (At{15, 7, 1}));
  d.set("state_i", StateReturn);
  d.set("restart_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, -5}));
  EXPECT_EQ(d.get("room_o"), 4);
}

TYPED_TEST(DecisionDatapathTest, RestartAndResetReturnToTheCameraFromAnywhere) {
  auto& d = this->dut;
  for (const char* cause : {"restart_i", "tracer_reset_i"}) {
    d.start({64, -224, 17}, 20);
    go_down(d, 3);
    d.descend(0, true, SolidRoom);
    EXPECT_TRUE(d.get("wall_o"));
    d.set(cause, 1);
    d.clock();
    EXPECT_EQ(d.place(), (At{0, 2, 0})) << cause;
    EXPECT_EQ(d.corner(), (vec3{64, -224, 17})) << cause;
    EXPECT_EQ(d.get("room_o"), 20) << cause;
    EXPECT_FALSE(d.get("wall_o")) << cause;
  }
}

// 11.6, the table of the interlace operation: z after each of its rows.
template <class Unit>
void expect_interlace(Dut<Unit>& d, bool on, const std::string& why) {
  constexpr int Z = 50, S = 128;
  for (const int sign : {0, 1}) {
    const int signs = sign << 2, mirror = sign ? -1 : 1, plus = on;
    SCOPED_TRACE(why + (sign ? ", z sign 1" : ", z sign 0"));
    d.scene = pillars;
    d.start({3, 5, Z}, room_of(4, 3, 0));
    d.descend(signs, false);
    EXPECT_EQ(d.corner(), (vec3{3 + 128, 5 + 256, mirror * (Z + plus) + S}));
    d.descend(signs, false);
    d.climb(tag_of(0, 2), signs);
    EXPECT_EQ(d.place(), (At{0, 2, 0}));
    const int left_over = on && sign ? 2 : 0;
    EXPECT_EQ(d.corner(), (vec3{3, 5, Z + left_over})) << "climb within depth 0";
    // And from deeper: down again, into the room beyond x, and back.
    d.start({3, 5, Z}, room_of(4, 3, 0));
    d.descend(signs, false);
    d.descend(signs, false);
    d.descend(signs, true, room_of(5, 3, 0));
    d.clock();
    EXPECT_EQ(d.place(), (At{1, 0, 0}));
    d.climb(tag_of(0, 2), signs, 0, room_of(4, 3, 0));
    d.climb(tag_of(0, 2), signs);
    EXPECT_EQ(d.place(), (At{0, 2, 0}));
    EXPECT_EQ(d.corner(), (vec3{3, 5, Z + plus})) << "arrival from deeper";
    d.descend(signs, false);
    EXPECT_EQ(d.corner()[2], mirror * (Z + 2 * plus) + S) << "they add up";
  }
}

TYPED_TEST(DecisionDatapathTest, OddLinesShowThePreviousPositionWithItsResidues) {
  auto& d = this->dut;
  d.set("scene_interlace_i", 1);
  for (const int y : {-239, 1, 237}) {
    d.set("y_i", y);
    expect_interlace(d, true, "y = " + std::to_string(y));
  }
}

TYPED_TEST(DecisionDatapathTest, InterlaceNeedsOddLineSceneAndPin) {
  auto& d = this->dut;
  d.set("scene_interlace_i", 1);
  d.set("y_i", -240);
  expect_interlace(d, false, "even line");
  d.set("y_i", -239);
  d.set("no_interlace_i", 1);
  expect_interlace(d, false, "pin");
  d.set("no_interlace_i", 0);
  d.set("scene_interlace_i", 0);
  expect_interlace(d, false, "scene");
}

}  // namespace
}  // namespace racebeam
