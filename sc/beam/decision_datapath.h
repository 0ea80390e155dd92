// decision_datapath: where the tracer is in the decision tree, and the decision it takes there.
//
// What    holds the place {depth, level}, the room, and the corner under test (relative to the
//         camera, mirrored so that the ray's components are not negative). A decision asks on
//         which side of an edge through the corner the ray passes: the sign of a 2x2 determinant,
//         two truncated 9 x 8 bit products. Descending and climbing move the corner by room sizes
//         and distances with one adder per axis. Levels of a room: 0, 1 far and 2, 3 near edges of
//         the portal it was entered by (not at depth 0, where 2 decides the ray's signs), 6 and 7
//         the face it is left by. Where a face has several portals, a ray that misses one goes to
//         the next, as to another room of the same depth; the last one's miss is the wall.
// Size    61 register bits; corner 3 x 12 bits signed, wraps. Several portals: 4 more, the number
//         of the portal entered by and of the one that leads back.
// Cycles  one decision, one descent or one climb a clock; a room change takes two (second = 1), so
//         does the move from one portal to the next.
// Comb    state_i, dr1_*_i, dr2_*_i -> dec_o; leave_i, climb_i, ray_signs_i, neighbour_i and the
//         nav_*_i, with several portals also top_tag_i -> look_*_o, fwrite_o. mask_o, tag_o,
//         wall_o, second_o, room_o, corner_*_o, hit_face_o, fdata_o: registers only.
// Stall   holds when nothing is asked.
// Reset   tracer_reset_i, restart_i (not on the nav_line), active_start_i on the nav_line: the
//         root, depth 0, level 2, at the camera. face, dom and hit_face are not reset.
// Knobs   dr_bits, corner_bits, corner_factor_bits, partial_products_cut, max_room_depth,
//         face_stack_depth, skip_shared_edges (the levels of an edge that lies on the edge of the
//         face are passed over. on: found by comparing rooms and kept by depth; not for the second
//         and later portals of a face, nor again for the first. table: while it is at levels 0 to
//         3, or half way into a room, it looks back through the portal it came by, and edges_i says
//         which; no registers). From the scene: portals_per_face.
// Twin    rtl/beam/decision_datapath.sv
// Test    tests/beam/decision_datapath_test.cpp
// Source  contract section 11; article "Geometry tests", "Subdeterminant calculation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/unit.h"
#include "sc/beam/decision_datapath_core.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Pins of decision_datapath.
class decision_datapath_pins : public sc_core::sc_module {
 public:
  // Clock; phase of the line
  in_port<1> clk_i{"clk_i"};
  in_port<1> tracer_reset_i{"tracer_reset_i"};
  in_port<1> nav_line_i{"nav_line_i"};
  in_port<1> active_start_i{"active_start_i"};
  in_port<10> y_i{"y_i"};  // bit 0: odd line
  // Pins of the chip, sequencer
  in_port<1> no_interlace_i{"no_interlace_i"};
  in_port<1> scene_interlace_i{"scene_interlace_i"};
  axes_in<VelocityPortBits> velocity_i{"velocity", "_i"};  // signed
  // navigator
  axes_in<NavigatorPortBits> nav_position_i{"nav_position", "_i"};  // signed
  in_port<RoomPortBits> nav_room_i{"nav_room_i"};
  in_port<2> nav_axis_i{"nav_axis_i"};
  in_port<PortalBits> nav_portal_i{"nav_portal_i"};
  in_port<1> nav_negative_i{"nav_negative_i"};
  in_port<3> nav_op_i{"nav_op_i"};  // corner_op
  in_port<1> nav_move_i{"nav_move_i"};
  axes_out<CornerPortBits> corner_o{"corner", "_o"};  // signed
  // ray_stepper
  axes_in<DrPortBits> dr1_i{"dr1", "_i"};  // signed, left end
  axes_in<DrPortBits> dr2_i{"dr2", "_i"};  // signed, right end
  // subdivider: the decision
  in_port<2> state_i{"state_i"};
  out_port<4> dec_o{"dec_o"};
  out_port<4> mask_o{"mask_o"};
  out_port<TagPortBits> tag_o{"tag_o"};  // {portal, depth, level}
  out_port<1> wall_o{"wall_o"};
  out_port<1> second_o{"second_o"};
  // subdivider: the move
  in_port<1> descend_i{"descend_i"};
  in_port<1> climb_i{"climb_i"};
  in_port<4> cur_i{"cur_i"};
  in_port<2> leave_i{"leave_i"};          // {leaves a face, decision}
  in_port<3> ray_signs_i{"ray_signs_i"};  // 1: negative
  in_port<1> restart_i{"restart_i"};
  // stacks
  in_port<TagPortBits> top_tag_i{"top_tag_i"};
  in_port<FacePortBits> fread_i{"fread_i"};
  out_port<1> fwrite_o{"fwrite_o"};
  out_port<FacePortBits> fdata_o{"fdata_o"};
  // scene
  out_port<RoomPortBits> room_o{"room_o"};
  out_port<2> look_axis_o{"look_axis_o"};
  out_port<3> look_signs_o{"look_signs_o"};
  out_port<PortalBits> look_portal_o{"look_portal_o"};
  out_port<2> look_way_o{"look_way_o"};  // look_way
  axes_in<CornerPortBits> half_size_i{"half_size", "_i"};
  axes_in<CornerPortBits> position_i{"position", "_i"};  // signed
  in_port<RoomPortBits> neighbour_i{"neighbour_i"};
  in_port<PortalBits> back_i{"back_i"};
  in_port<4> edges_i{"edges_i", OfKnob};  // of the face looked through: no test needed
  // pixel_output
  out_port<2> hit_face_o{"hit_face_o"};  // axis of the wall hit

  explicit decision_datapath_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of decision_datapath: its core behind the pins.
class decision_datapath : public decision_datapath_pins, public probed {
 public:
  using pins = decision_datapath_pins;
  static constexpr const char* unit_name = "decision_datapath";

  decision_datapath(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void decide();
  void lookup();
  decision_datapath_core::inputs inputs() const;

  const knobs knobs_;
  decision_datapath_core core_;
  sc_core::sc_event face_moved_{"face_moved"};
};

}  // namespace racebeam
