// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_inputs.h"

namespace racebeam {

sphere_inputs::sphere_inputs(const sc_core::sc_module_name& name, const sphere_tables& tables)
    : sphere_inputs_pins(name), start_(tables.start) {
  SC_HAS_PROCESS(sphere_inputs);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << rst_ni << key_ni;
}

void sphere_inputs::seq() {
  const sphere_inputs_core::inputs in{rst_ni.value() != 0, sw_i.value(), key_ni.value(),
                                      picture_done_i.value() != 0};
  if (core_.rst_n(in) && !in.picture_done) return;
  core_.clock(in, start_);
  drive();
}

void sphere_inputs::deposit(const sphere_inputs_core& registers) {
  core_ = registers;
  drive();
}

void sphere_inputs::drive() {
  rotz_o.drive(core_.rotz_q);
  origin_o.drive(core_.origin_q);
  light_o.drive(core_.light_q);
  screen_o.drive(core_.screen_q);
  max_reflections_o.drive(core_.max_reflections_q);
  alias_o.drive(core_.alias_q);
  narrow_o.drive(core_.narrow_q);
  planes_o.drive(core_.planes_q);
  scene_o.drive(core_.scene_q);
}

void sphere_inputs::comb() {
  rst_no.drive(sphere_inputs_core::rst_n({rst_ni.value() != 0, 0, key_ni.value(), false}));
}

}  // namespace racebeam
