// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/decision_datapath.h"

#include "sc/beam/navigator.h"
#include "sc/beam/scene.h"
#include "sc/beam/subdivider.h"

namespace racebeam {

decision_datapath::decision_datapath(const sc_core::sc_module_name& name, const knobs& k)
    : decision_datapath_pins(name), knobs_(k) {
  SC_HAS_PROCESS(decision_datapath);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(decide);
  sensitive << state_i << dr1_i.x << dr1_i.y << dr1_i.z << dr2_i.x << dr2_i.y << dr2_i.z;
  SC_METHOD(lookup);
  sensitive << face_moved_ << leave_i << climb_i << ray_signs_i << nav_line_i << nav_axis_i
            << nav_negative_i << nav_portal_i << neighbour_i;
  if (k.portals_per_face > 1) sensitive << top_tag_i;
}

decision_datapath_core::inputs decision_datapath::inputs() const {
  decision_datapath_core::inputs in;
  in.tracer_reset = tracer_reset_i.value();
  in.restart = restart_i.value();
  in.nav_line = nav_line_i.value();
  in.active_start = active_start_i.value();
  in.nav_position = nav_position_i.signed_value();
  in.nav_room = nav_room_i.value();
  in.nav_axis = nav_axis_i.value();
  in.nav_negative = nav_negative_i.value();
  in.nav_move = nav_move_i.value();
  in.nav_op = nav_op_i.value();
  in.velocity = velocity_i.signed_value();
  in.descend = descend_i.value();
  in.climb = climb_i.value();
  in.in_return = state_i.value() == StateReturn;
  in.cur = cur_i.value();
  in.leave = leave_i.value();
  in.signs = ray_signs_i.value();
  in.top_tag = top_tag_i.value();
  in.face_read = fread_i.value();
  in.half_size = half_size_i.signed_value();
  in.position = position_i.signed_value();
  in.neighbour = neighbour_i.value();
  in.back = back_i.value();
  in.edges = edges_i.value();
  in.interlace =
      !no_interlace_i.value() && scene_interlace_i.value() && (y_i.value() & 1) && !in.nav_line;
  return in;
}

void decision_datapath::seq() {
  const bool idle = !descend_i.value() && !climb_i.value() && !core_.second_q && !core_.descend_q &&
                    !core_.wall_q;
  if (idle && !tracer_reset_i.value() && !restart_i.value() && !nav_line_i.value()) return;
  const int face = core_.face_q;
  const bool dom = core_.dom_q, leaf = core_.level_q == 7;
  core_.clock(inputs(), knobs_);
  mask_o.drive(core_.mask());
  tag_o.drive(core_.tag());
  wall_o.drive(core_.wall_q);
  second_o.drive(core_.second_q);
  room_o.drive(core_.room_q);
  corner_o.drive(core_.corner_q);
  hit_face_o.drive(core_.hit_face_q);
  fdata_o.drive(core_.face_code());
  decide();  // with the rays of before the edge; again when they change
  if (core_.face_q != face || core_.dom_q != dom || (core_.level_q == 7) != leaf ||
      knobs_.portals_per_face > 1 || knobs_.skip_shared_edges == SharedEdgesTable)
    face_moved_.notify(sc_core::SC_ZERO_TIME);
}

void decision_datapath::decide() {
  dec_o.drive(core_.decide(
      state_i.value() == StateLeft ? dr1_i.signed_value() : dr2_i.signed_value(), knobs_));
}

void decision_datapath::lookup() {
  decision_datapath_core::inputs in{};
  in.nav_line = nav_line_i.value();
  in.nav_axis = nav_axis_i.value();
  in.nav_negative = nav_negative_i.value();
  in.climb = climb_i.value();
  in.leave = leave_i.value();
  in.signs = ray_signs_i.value();
  in.nav_portal = nav_portal_i.value();
  in.neighbour = neighbour_i.value();
  in.top_tag = top_tag_i.value();
  const auto look = core_.look(in, knobs_);
  look_axis_o.drive(look.axis);
  look_signs_o.drive(look.signs);
  look_portal_o.drive(look.portal);
  look_way_o.drive(look.way);
  fwrite_o.drive(core_.face_write(in));
}

}  // namespace racebeam
