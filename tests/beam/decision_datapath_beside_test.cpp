// Promises of sc/beam/decision_datapath.h: no input is missed, with several portals in a face.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/beside.h"
#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

knobs four_portals() {
  knobs k;
  k.portals_per_face = 4;
  k.dr_bits = DrPortBits;  // all bits of the random rays count
  return k;
}

template <class Unit>
class DecisionDatapathBesideTest : public testing::Test {
 protected:
  Dut<Unit> dut{four_portals()};
};
TYPED_TEST_SUITE(DecisionDatapathBesideTest, Twins);

TYPED_TEST(DecisionDatapathBesideTest, NoInputIsMissedUnderRandomOnes) {
  auto& d = this->dut;
  decision_datapath_core core;
  const knobs k = four_portals();
  const auto inputs = [&] {
    decision_datapath_core::inputs in;
    in.tracer_reset = d.get("tracer_reset_i");
    in.restart = d.get("restart_i");
    in.nav_line = d.get("nav_line_i");
    in.active_start = d.get("active_start_i");
    in.nav_position = d.bench.read("nav_position", "_i");
    in.nav_room = d.get("nav_room_i");
    in.nav_axis = d.get("nav_axis_i");
    in.nav_portal = d.get("nav_portal_i");
    in.nav_negative = d.get("nav_negative_i");
    in.nav_move = d.get("nav_move_i");
    in.nav_op = d.get("nav_op_i");
    in.velocity = d.bench.read("velocity", "_i");
    in.descend = d.get("descend_i");
    in.climb = d.get("climb_i");
    in.in_return = d.get("state_i") == StateReturn;
    in.cur = d.get("cur_i");
    in.signs = d.get("ray_signs_i");
    in.leave = d.get("leave_i");
    in.top_tag = d.get("top_tag_i");
    in.face_read = d.get("fread_i");
    in.half_size = d.bench.read("half_size", "_i");
    in.position = d.bench.read("position", "_i");
    in.neighbour = d.get("neighbour_i");
    in.back = d.get("back_i");
    in.interlace =
        !d.get("no_interlace_i") && d.get("scene_interlace_i") && d.get("y_i") % 2 && !in.nav_line;
    return in;
  };
  const auto check = [&] {
    const auto in = inputs();
    const auto look = core.look(in, k);
    EXPECT_EQ(d.get("look_axis_o"), look.axis);
    EXPECT_EQ(d.get("look_signs_o"), look.signs);
    EXPECT_EQ(d.get("look_portal_o"), look.portal);
    EXPECT_EQ(d.get("look_way_o"), look.way);
    EXPECT_EQ(d.get("fwrite_o"), core.face_write(in));
    const auto dr = d.bench.read(d.get("state_i") == StateLeft ? "dr1" : "dr2", "_i");
    EXPECT_EQ(d.get("dec_o"), core.decide(dr, k));
    EXPECT_EQ(d.get("mask_o"), core.mask());
    EXPECT_EQ(d.get("tag_o"), core.tag());
    EXPECT_EQ(d.get("wall_o"), core.wall_q);
    EXPECT_EQ(d.get("second_o"), core.second_q);
    EXPECT_EQ(d.get("room_o"), core.room_q);
    EXPECT_EQ(d.corner(), core.corner_q);
    EXPECT_EQ(d.get("hit_face_o"), core.hit_face_q);
    EXPECT_EQ(d.get("fdata_o"), core.face_code());
  };
  d.set("tracer_reset_i", 1);
  d.bench.settle();
  core.clock(inputs(), k);
  d.bench.clock();
  run_beside(
      d.bench, 44, 40000, [&] { core.clock(inputs(), k); }, check);
}

}  // namespace
}  // namespace racebeam
