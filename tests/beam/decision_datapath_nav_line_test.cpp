// Promises of sc/beam/decision_datapath.h: the corner is the navigator's on the nav_line, contract
// sections 11.1 and 13.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using DecisionDatapathNavLineTest = DecisionDatapathTest<Unit>;
TYPED_TEST_SUITE(DecisionDatapathNavLineTest, Twins);

// 11.1: on the nav_line active_start re-roots, a restart does not; elsewhere it is the other way.
TYPED_TEST(DecisionDatapathNavLineTest, NavLineRerootsAtActiveStartOnly) {
  auto& d = this->dut;
  d.start({0, -224, 17}, 20);
  go_down(d, 0);
  const vec3 moved = d.corner();
  d.set("active_start_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 0})) << "not the nav_line";
  EXPECT_EQ(d.corner(), moved);
  d.set("nav_line_i", 1);
  d.set("restart_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 0})) << "restart on the nav_line";
  EXPECT_EQ(d.corner(), moved);
  d.set("active_start_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, 17}));
  d.descend(0, true);
  EXPECT_EQ(d.place(), (At{0, 6, 0})) << "the tree goes on";
  EXPECT_EQ(d.corner(), (vec3{0, -224, 17})) << "the corner is the navigator's";
}

// 13: y = 251 of frame 129.
TYPED_TEST(DecisionDatapathNavLineTest, NavLineTraceOfFrame129) {
  auto& d = this->dut;
  d.scene = pillars;
  d.set("y_i", 251);
  d.set("scene_interlace_i", 1);
  d.bench.drive("velocity", "_i", {0, 0, -1});
  d.start({0, -224, -128}, room_of(4, 0, 0));
  d.set("nav_line_i", 1);
  d.set("active_start_i", 1);
  d.clock();
  struct {
    int op, move;
    vec3 corner;
    int j;
  } const rows[] = {{CornerAddVelocity, 0, {0, -224, -129}, 0},
                    {CornerAddS, 0, {128, 32, -1}, 0},
                    {CornerLeavePlus, 1, {-1024, -224, -129}, 1},
                    {CornerAddR, 0, {0, -224, 127}, 1},
                    {CornerHold, 0, {0, -224, 127}, 1}};
  EXPECT_EQ(d.corner(), (vec3{0, -224, -128})) << "c = 320";
  d.set("nav_axis_i", 2);
  d.set("neighbour_i", room_of(4, 1, 0));
  for (const auto& row : rows) {
    d.set("nav_op_i", row.op);
    d.set("nav_move_i", row.move);
    d.settle();
    EXPECT_EQ(d.get("look_axis_o"), 2);
    EXPECT_EQ(d.get("look_signs_o"), 0);
    d.clock();
    EXPECT_EQ(d.corner(), row.corner);
    EXPECT_EQ(d.get("room_o"), room_of(4, row.j, 0));
  }
}

TYPED_TEST(DecisionDatapathNavLineTest, NavLineOperationsAddSizesAndDistances) {
  auto& d = this->dut;
  d.scene = [](int) { return Box{{700, -272, -900}, {96, 16, 80}}; };
  const vec3 start{64, -224, 100};
  const auto after = [&](int op, int velocity = 0) {
    d.start(start, 9);
    d.set("nav_line_i", 1);
    d.set("nav_op_i", op);
    d.bench.drive("velocity", "_i", {0, 0, velocity});
    d.clock();
    d.set("nav_line_i", 0);
    return d.corner();
  };
  EXPECT_EQ(after(CornerHold, -1), start);
  EXPECT_EQ(after(CornerAddVelocity, -2), (vec3{64, -224, 98}));
  EXPECT_EQ(after(CornerAddVelocity, 1), (vec3{64, -224, 101}));
  EXPECT_EQ(after(CornerAddS), (vec3{160, -208, 180}));
  EXPECT_EQ(after(CornerSubtract2S), (vec3{-128, -256, -60}));
  EXPECT_EQ(after(CornerLeavePlus), (vec3{-732, 32, 920}));
  EXPECT_EQ(after(CornerLeaveMinus), (vec3{-540, 64, 1080}));
  EXPECT_EQ(after(CornerAddR), (vec3{764, -496, -800}));
}

TYPED_TEST(DecisionDatapathNavLineTest, NavLineLooksWhereTheNavigatorLooks) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  d.set("nav_line_i", 1);
  d.set("ray_signs_i", 5);
  for (int axis = 0; axis < 3; ++axis)
    for (const int negative : {0, 1}) {
      d.set("nav_axis_i", axis);
      d.set("nav_negative_i", negative);
      d.settle();
      EXPECT_EQ(d.get("look_axis_o"), axis);
      EXPECT_EQ(d.get("look_signs_o") >> axis & 1, negative);
    }
}

}  // namespace
}  // namespace racebeam
