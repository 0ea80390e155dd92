// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_shade.h"

namespace racebeam {

block_shade::block_shade(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_shade_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_shade);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << dir_i.x << dir_i.y << dir_i.z << centre_i.x << centre_i.y << centre_i.z << light_i.x
            << light_i.y << light_i.z << clocked_;
}

block_shade_core::inputs block_shade::inputs() const {
  return {
      rst_ni.value() != 0,
      start_i.value() != 0,
      position_i.signed_value(),
      dir_i.signed_value(),
      static_cast<int>(distance_i.signed_value()),
      centre_i.signed_value(),
      light_i.signed_value(),
      {static_cast<int>(base_red_i.signed_value()), static_cast<int>(base_green_i.signed_value()),
       static_cast<int>(base_blue_i.signed_value())},
      unit_i.signed_value(),
      unit_done_i.value() != 0};
}

void block_shade::seq() {
  core_.clock(inputs(), knobs_);
  point_o.drive(core_.point_q);
  colour_red_o.drive(static_cast<std::uint64_t>(core_.colour_q[0]));
  colour_green_o.drive(static_cast<std::uint64_t>(core_.colour_q[1]));
  colour_blue_o.drive(static_cast<std::uint64_t>(core_.colour_q[2]));
  done_o.drive(core_.done());
  normalise_o.drive(core_.normalise());
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void block_shade::comb() {
  const block_shade_core::inputs in = inputs();
  v_o.drive(core_.vector(in));
  direction_o.drive(core_.direction(in));
}

}  // namespace racebeam
