// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/frame_memory.h"

namespace racebeam {

frame_memory::frame_memory(const sc_core::sc_module_name& name, const store_knobs& k)
    : frame_memory_pins(name), knobs_(k), core_(k) {
  SC_HAS_PROCESS(frame_memory);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

void frame_memory::seq() {
  core_.clock({mem_write_i.value() != 0, mem_address_i.value(), mem_data_i.value()}, knobs_);
  mem_data_o.drive(core_.data_q);
}

}  // namespace racebeam
