// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_root.h"

namespace racebeam {

block_root::block_root(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_root_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_root);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << d_i;
}

void block_root::seq() {
  core_.clock({rst_ni.value() != 0, start_i.value() != 0, d_i.value()}, knobs_);
  comb();
}

void block_root::comb() {
  root_o.drive(core_.root(d_i.value(), knobs_));
  done_o.drive(core_.done(knobs_));
}

}  // namespace racebeam
