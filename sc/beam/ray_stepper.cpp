// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/ray_stepper.h"

namespace racebeam {

ray_stepper::ray_stepper(const sc_core::sc_module_name& name, const knobs& k)
    : ray_stepper_pins(name), knobs_(k) {
  SC_HAS_PROCESS(ray_stepper);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

void ray_stepper::seq() {
  ray_stepper_core::inputs in;
  in.step = step_i.value();
  in.copy_sub = copy_sub_i.value();
  in.tracer_reset = tracer_reset_i.value();
  in.load = load_i.value();
  if (!in.step && !in.copy_sub && !in.tracer_reset && !in.load) return;
  in.load_zero = load_zero_i.value();
  in.ext = ext_i.value();
  in.ext_sign = ext_sign_i.value();
  in.axis_mask = axis_mask_i.value();
  in.delta = delta_i.signed_value();
  in.copy_ext = copy_ext_i.value();
  in.neg = neg_i.value();
  in.step_size = step_size_i.value();
  in.idx2 = idx2_i.value();
  core_.clock(in, knobs_);
  dr1_o.drive(core_.dr1_q);
  dr2_o.drive(core_.dr2_q);
}

}  // namespace racebeam
