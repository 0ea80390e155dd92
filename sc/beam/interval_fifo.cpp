// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/interval_fifo.h"

namespace racebeam {

interval_fifo::interval_fifo(const sc_core::sc_module_name& name, const knobs& k)
    : interval_fifo_pins(name), knobs_(k) {
  SC_HAS_PROCESS(interval_fifo);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << emit_i;
}

interval_fifo_core::inputs interval_fifo::inputs() const {
  const bool half = knobs_.dithering == DitheringCheckered && half_i.value();
  return {tracer_reset_i.value() != 0, consume_i.value() != 0, emit_i.value() != 0,
          len_m1_i.value(), value_i.value() | half * HalfTone};
}

void interval_fifo::seq() {
  const auto in = inputs();
  if (core_.idle(in, knobs_)) return;
  core_.clock(in, knobs_);
  drive();
  ack_o.drive(core_.ack(in, knobs_));  // again when the offer or the beam changes
}

// The outputs that are registers only; at power-up too.
void interval_fifo::drive() {
  starving_o.drive(core_.starving(knobs_));
  const int display = core_.display(knobs_);
  display_o.drive(display & IndexMask);
  display_half_o.drive(display >= HalfTone);
  fill_o.drive(core_.fill(knobs_));
}

// Without an offer there is no answer, and nothing else to listen to.
void interval_fifo::comb() {
  ack_o.drive(core_.ack(inputs(), knobs_));
  if (emit_i.value()) {
    if (offer_events_.size() == 0)
      offer_events_ = emit_i->value_changed_event() | len_m1_i->value_changed_event() |
                      value_i->value_changed_event() | half_i->value_changed_event() |
                      consume_i->value_changed_event();
    next_trigger(offer_events_);
  }
}

}  // namespace racebeam
