// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_normalise.h"

namespace racebeam {

block_normalise::block_normalise(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_normalise_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_normalise);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << v_i.x << v_i.y << v_i.z << clocked_;
}

void block_normalise::seq() {
  core_.clock({rst_ni.value() != 0, start_i.value() != 0, v_i.signed_value()}, knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void block_normalise::comb() {
  const auto o = core_.comb(v_i.signed_value(), knobs_);
  unit_o.drive(o.unit);
  done_o.drive(o.done);
  small_o.drive(core_.small());
}

}  // namespace racebeam
