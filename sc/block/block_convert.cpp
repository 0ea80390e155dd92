// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_convert.h"

#include <utility>

namespace racebeam {

block_convert::block_convert(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_convert_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_convert);
  SC_METHOD(seq);
  sensitive << valid_i << rst_ni;
  SC_METHOD(comb);
  sensitive << valid_i << float_i << field_i << index_i << clocked_;
}

block_convert_core::inputs block_convert::inputs() const {
  return {rst_ni.value() != 0, valid_i.value() != 0, static_cast<std::uint32_t>(float_i.value()),
          field_i.value(), index_i.value()};
}

// Without a number it sleeps.
void block_convert::seq() {
  if (!std::exchange(asleep_, false)) {
    const auto in = inputs();
    asleep_ = core_.idle(in);
    core_.clock(in, knobs_);
    eye_o.drive(core_.eye_q);
    light_o.drive(core_.light_q);
    start_o.drive(core_.start());
    clocked_.notify(sc_core::SC_ZERO_TIME);
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

void block_convert::comb() {
  const auto o = core_.comb(inputs(), knobs_);
  ready_o.drive(o.ready);
  write_o.drive(o.write);
  field_o.drive(o.field);
  index_o.drive(o.index);
  fixed_o.drive(static_cast<std::uint64_t>(o.fixed));
  eye_k_o.drive(static_cast<std::uint64_t>(o.eye_k));
}

}  // namespace racebeam
