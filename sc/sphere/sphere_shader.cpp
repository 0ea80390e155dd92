// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_shader.h"

namespace racebeam {

sphere_shader::sphere_shader(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : sphere_shader_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sphere_shader);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(weigh);
  sensitive << reflect_i;
  SC_METHOD(mix);
  sensitive << sub_i << alias_i;
}

void sphere_shader::seq() {
  if (op_i.value() == ShadeHold && rst_ni.value()) return;
  core_.clock({rst_ni.value() != 0,
               op_i.value(),
               {base_red_i.value(), base_green_i.value(), base_blue_i.value()},
               dark_i.value() != 0,
               fraction_i.value(),
               reflect_i.value(),
               direct_i.value() != 0,
               sub_i.value(),
               alias_i.value()});
  weigh();
  mix();
}

void sphere_shader::weigh() { weight_o.drive(core_.weight(reflect_i.value())); }

void sphere_shader::mix() { word_o.drive(core_.word(sub_i.value(), alias_i.value(), knobs_)); }

}  // namespace racebeam
