// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/divider_unit.h"

namespace racebeam {

divider_unit::divider_unit(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : divider_unit_pins(name), knobs_(k) {
  SC_HAS_PROCESS(divider_unit);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

void divider_unit::seq() {
  const divider_unit_core::inputs in{
      rst_ni.value() != 0,
      start_i.value() != 0,
      {numerator_i.x.signed_value(), numerator_i.y.signed_value(), numerator_i.z.signed_value()},
      denominator_i.signed_value()};
  if (core_.idle(in)) return;
  core_.clock(in, knobs_);
  quotient_o.drive(core_.quotient());
  done_o.drive(core_.done_q);
}

}  // namespace racebeam
