// subdivider: traces a scan line as intervals of pixels through the decision tree.
//
// What    LEFT decides at pixel i1, RIGHT at i2. If both ends agree the whole interval descends;
//         otherwise BISECT finds the switching pixel, the right part is pushed on the stack and
//         the left part descends. A wall hit is offered to the FIFO and RETURN climbs to the
//         youngest stacked interval. With an empty stack the tracer restarts at the top of the
//         tree with i1 = first pixel not emitted, i2 = 639. When the beam starves, short intervals
//         are given up (hurry). After the interval that ends at 639, emit stays 0 but the tracer
//         runs on.
// Size    64 register bits. Pixels are 10 bits and wrap.
// Cycles  one decision a clock and end; bisection of width w about log2(w); a return at least 2.
// Comb    tracer_reset_i, wall_i, starving_i -> emit_o; and with dec_i, mask_i, second_i, tag_i,
//         top_tag_i, top_i2_i, ack_i, lock_i, consume_i -> step_o, neg_o, step_size_o, copy_sub_o,
//         push_en_o, descend_o, climb_o, cur_o, leave_o, restart_o. state_o, i2_o, idx2_o,
//         len_m1_o, ray_signs_o, sp_o, sd_o, line_done_o: registers only.
// Stall   holds in RETURN while an offer is not accepted; in LEFT while second_i.
// Reset   tracer_reset_i: LEFT, i1 = 0, i2 = i2_init_i, stack empty; idx2 is camera_unit's.
// Knobs   interval_stack_depth, hurry_threshold, bisection; from the scene: portals_per_face (with
//         several, leave_o also tells of a ray that passes the edge of a portal).
// Twin    rtl/beam/subdivider.sv
// Test    tests/beam/subdivider_test.cpp
// Source  contract section 9; article "Subdivision" and "Stepping the dr vector".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/unit.h"
#include "sc/beam/knobs.h"
#include "sc/beam/subdivider_core.h"

namespace racebeam {

/// Pins of subdivider.
class subdivider_pins : public sc_core::sc_module {
 public:
  // Clock; phase of the line
  in_port<1> clk_i{"clk_i"};
  in_port<1> tracer_reset_i{"tracer_reset_i"};
  // camera_unit
  in_port<1> idx_load_i{"idx_load_i"};
  in_port<PixelBits> idx_start_i{"idx_start_i"};
  in_port<PixelBits> i2_init_i{"i2_init_i"};
  // decision_datapath: the decision
  out_port<2> state_o{"state_o"};  // LEFT decides with dr1, all others with dr2
  in_port<4> dec_i{"dec_i"};       // {sign z, sign y, sign x, bit}
  in_port<4> mask_i{"mask_i"};     // bits of dec that count
  in_port<1> wall_i{"wall_i"};
  in_port<1> second_i{"second_i"};      // half way through a room change
  in_port<TagPortBits> tag_i{"tag_i"};  // {portal, depth, level}
  // decision_datapath: the move
  out_port<1> descend_o{"descend_o"};
  out_port<1> climb_o{"climb_o"};
  out_port<4> cur_o{"cur_o"};              // decision to descend with; 0 otherwise
  out_port<2> leave_o{"leave_o"};          // {leaves a face, decision}; 0 otherwise
  out_port<3> ray_signs_o{"ray_signs_o"};  // stored ray signs, 1: negative
  out_port<1> restart_o{"restart_o"};
  // interval_fifo
  out_port<1> emit_o{"emit_o"};              // interval i1..i2 on offer
  out_port<PixelBits> len_m1_o{"len_m1_o"};  // i2 - i1
  in_port<1> ack_i{"ack_i"};
  in_port<1> starving_i{"starving_i"};
  // ray_stepper
  out_port<1> step_o{"step_o"};
  out_port<1> neg_o{"neg_o"};
  out_port<11> step_size_o{"step_size_o"};  // pixels
  out_port<PixelBits> idx2_o{"idx2_o"};
  out_port<1> copy_sub_o{"copy_sub_o"};
  // stacks: the entry written is {tag, i2}
  out_port<1> push_en_o{"push_en_o"};
  out_port<PixelBits> i2_o{"i2_o"};
  out_port<StackPointerPortBits> sp_o{"sp_o"};
  out_port<StackCountPortBits> sd_o{"sd_o"};
  in_port<TagPortBits> top_tag_i{"top_tag_i"};
  in_port<PixelBits> top_i2_i{"top_i2_i"};
  // Lock effect
  in_port<1> lock_i{"lock_i"};
  in_port<1> consume_i{"consume_i"};
  // Line
  out_port<1> line_done_o{"line_done_o"};  // the interval ending at 639 was accepted

  explicit subdivider_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of subdivider: its core behind the pins.
class subdivider : public subdivider_pins, public probed {
 public:
  using pins = subdivider_pins;
  static constexpr const char* unit_name = "subdivider";

  subdivider(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();
  void drive();

  const knobs knobs_;
  subdivider_core core_;
  subdivider_core::inputs in_{};
  subdivider_core::outputs out_{};
  sc_core::sc_event_or_list lock_events_;
};

}  // namespace racebeam
