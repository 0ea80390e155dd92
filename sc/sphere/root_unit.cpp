// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/root_unit.h"

namespace racebeam {

root_unit::root_unit(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : root_unit_pins(name), knobs_(k) {
  SC_HAS_PROCESS(root_unit);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

void root_unit::seq() {
  const root_unit_core::inputs in{rst_ni.value() != 0, start_i.value() != 0, radicand_i.value()};
  if (core_.idle(in)) return;
  core_.clock(in, knobs_);
  root_o.drive(core_.root_q);
  done_o.drive(core_.done_q);
}

}  // namespace racebeam
