// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/store_arbiter.h"

namespace racebeam {

store_arbiter::store_arbiter(const sc_core::sc_module_name& name, const store_knobs& k)
    : store_arbiter_pins(name), knobs_(k) {
  SC_HAS_PROCESS(store_arbiter);
  SC_METHOD(comb);
  sensitive << read_i << read_address_i << sync_i << blank_i << take_valid_i << take_address_i
            << take_data_i;
}

void store_arbiter::comb() {
  const bool ready = store_arbiter_core::take_ready(read_i.value() != 0, sync_i.value() != 0,
                                                    blank_i.value() != 0, knobs_);
  const bool write = ready && take_valid_i.value();
  take_ready_o.drive(ready);
  mem_write_o.drive(write);
  mem_address_o.drive(write ? take_address_i.value() : read_address_i.value());
  mem_data_o.drive(take_data_i.value());
}

}  // namespace racebeam
