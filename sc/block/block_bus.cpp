// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_bus.h"

namespace racebeam {

block_bus::block_bus(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_bus_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_bus);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << word_valid_i << bus_ready_i << clocked_;
}

void block_bus::seq() {
  core_.clock(rst_ni.value() != 0, word_valid_i.value(), bus_ready_i.value() != 0, knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void block_bus::comb() {
  const std::uint64_t up = core_.up(word_valid_i.value(), knobs_);
  bus_valid_o.drive(up != 0);
  core_o.drive(block_bus_core::number(up));
  word_ready_o.drive(bus_ready_i.value() ? up : 0);
}

}  // namespace racebeam
