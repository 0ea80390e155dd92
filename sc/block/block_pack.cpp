// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_pack.h"

namespace racebeam {

block_pack::block_pack(const sc_core::sc_module_name& name) : block_pack_pins(name) {
  SC_HAS_PROCESS(block_pack);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << valid_i << clocked_;
}

void block_pack::seq() {
  core_.clock(
      {rst_ni.value() != 0, valid_i.value() != 0, red_i.value(), green_i.value(), blue_i.value()});
  red_o.drive(core_.red_q);
  green_o.drive(core_.green_q);
  blue_o.drive(core_.blue_q);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void block_pack::comb() { full_o.drive(core_.full(valid_i.value() != 0)); }

}  // namespace racebeam
