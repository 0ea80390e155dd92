// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/write_buffer.h"

namespace racebeam {

write_buffer::write_buffer(const sc_core::sc_module_name& name, const store_knobs& k)
    : write_buffer_pins(name), knobs_(k) {
  SC_HAS_PROCESS(write_buffer);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << take_ready_i;
}

void write_buffer::seq() {
  const write_buffer_core::inputs in{rst_ni.value() != 0,
                                     put_valid_i.value() != 0,
                                     {put_address_i.value(), put_data_i.value()},
                                     take_ready_i.value() != 0};
  if (core_.idle(in)) return;
  core_.clock(in, knobs_);
  const auto& take = core_.take();
  take_valid_o.drive(core_.take_valid());
  take_address_o.drive(take.address);
  take_data_o.drive(take.data);
  fill_o.drive(core_.fill(knobs_));
  comb();
}

void write_buffer::comb() { put_ready_o.drive(core_.put_ready(take_ready_i.value() != 0, knobs_)); }

}  // namespace racebeam
