// store_arbiter: who has the memory in this clock, the beam or the tracer.
//
// What    the beam comes first: while read_i is 1 nothing is taken. Otherwise take_ready_o follows
//         write_policy: sync_i (sync), blank_i (blanking), or 1 (free). A word is written in a
//         clock in which take_valid_i and take_ready_o are 1: mem_write_o is 1 and mem_address_o is
//         take_address_i. In all other clocks mem_address_o is read_address_i. mem_data_o is always
//         take_data_i.
// Size    no registers.
// Cycles  combinational: a word is in the memory from the next clock on.
// Comb    read_i -> take_ready_o; sync_i -> take_ready_o (sync only); blank_i -> take_ready_o
//         (blanking only). These and take_valid_i, take_address_i, read_address_i -> mem_write_o,
//         mem_address_o; take_data_i -> mem_data_o. take_ready_o does not depend on take_*.
// Stall   none.
// Reset   none.
// Knobs   write_policy.
// Twin    rtl/store/store_arbiter.sv: WritePolicy
// Test    tests/store/store_arbiter_test.cpp
// Source  FPGA sphere tracer: writes while a sync is low (sync); its early labs: in blanking.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/unit.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Behaviour of store_arbiter.
struct store_arbiter_core {
  /// The tracer may write in this clock.
  static bool take_ready(bool read, bool sync, bool blank, const store_knobs& k) {
    return !read && (k.write_policy == WritePolicySync       ? sync
                     : k.write_policy == WritePolicyBlanking ? blank
                                                             : true);
  }
};

/// Pins of store_arbiter.
class store_arbiter_pins : public sc_core::sc_module {
 public:
  // Beam: frame_scanout, and vga_timing in the same clock
  in_port<1> read_i{"read_i"};
  in_port<StoreAddressBits> read_address_i{"read_address_i"};
  in_port<1> sync_i{"sync_i"};    // hsync or vsync is low
  in_port<1> blank_i{"blank_i"};  // no visible pixel
  // write_buffer
  in_port<1> take_valid_i{"take_valid_i"};
  in_port<StoreAddressBits> take_address_i{"take_address_i"};
  in_port<StoreDataBits> take_data_i{"take_data_i"};
  out_port<1> take_ready_o{"take_ready_o"};
  // frame_memory
  out_port<1> mem_write_o{"mem_write_o"};
  out_port<StoreAddressBits> mem_address_o{"mem_address_o"};
  out_port<StoreDataBits> mem_data_o{"mem_data_o"};

  explicit store_arbiter_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of store_arbiter: its core behind the pins.
class store_arbiter : public store_arbiter_pins {
 public:
  using pins = store_arbiter_pins;
  static constexpr const char* unit_name = "store_arbiter";

  store_arbiter(const sc_core::sc_module_name& name, const store_knobs& k);

 private:
  void comb();

  const store_knobs knobs_;
};

}  // namespace racebeam
