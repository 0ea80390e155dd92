// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_bus.h"

#include <utility>

namespace racebeam {

block_bus::block_bus(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_bus_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_bus);
  SC_METHOD(seq);
  sensitive << word_valid_i << bus_ready_i << rst_ni;
  SC_METHOD(comb);
  sensitive << word_valid_i << bus_ready_i << clocked_;
}

// While nobody is served it sleeps.
void block_bus::seq() {
  if (!std::exchange(asleep_, false)) {
    const bool rst_n = rst_ni.value() != 0, ready = bus_ready_i.value() != 0;
    const std::uint64_t asks = word_valid_i.value();
    asleep_ = rst_n && !(ready && core_.up(asks, knobs_));
    core_.clock(rst_n, asks, ready, knobs_);
    clocked_.notify(sc_core::SC_ZERO_TIME);
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

void block_bus::comb() {
  const std::uint64_t up = core_.up(word_valid_i.value(), knobs_);
  bus_valid_o.drive(up != 0);
  core_o.drive(block_bus_core::number(up));
  word_ready_o.drive(bus_ready_i.value() ? up : 0);
}

}  // namespace racebeam
