// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/interval_fifo.h"

namespace racebeam {

interval_fifo::interval_fifo(const sc_core::sc_module_name& name, const knobs& k)
    : sc_module(name), knobs_(k) {
  SC_HAS_PROCESS(interval_fifo);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << emit_i << len_m1_i << value_i << consume_i;
}

interval_fifo_core::inputs interval_fifo::inputs() const {
  return {tracer_reset_i.value() != 0, consume_i.value() != 0, emit_i.value() != 0,
          len_m1_i.value(), value_i.value()};
}

void interval_fifo::seq() {
  core_.clock(inputs(), knobs_);
  starving_o.drive(core_.starving(knobs_));
  display_o.drive(core_.display(knobs_));
  fill_o.drive(core_.fill(knobs_));
  if (emit_i.value()) comb();
}

void interval_fifo::comb() { ack_o.drive(core_.ack(inputs(), knobs_)); }

}  // namespace racebeam
