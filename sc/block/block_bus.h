// block_bus: one word of the cores at a time, in turn.
//
// What    Of the cores that ask (word_valid_i), the first after the one that was served last is up:
//         core_o is its number, bus_valid_o tells that there is one, word_ready_o has its bit while
//         bus_ready_i. A core that is served in a clock comes last from the next clock on. The
//         multiplexer of the words lies where the cores are.
// Size    a bit a core, two priority encoders.
// Cycles  a word a clock, no idle clock between.
// Comb    word_valid_i, bus_ready_i -> all outputs.
// Stall   bus_ready_i = 0: nobody is served, and the turn stays.
// Reset   rst_ni = 0: the lowest core is first.
// Knobs   cores, 1..64: parameter Cores; bits of cores that there are not do not count.
// Twin    rtl/block/block_bus.sv
// Test    tests/block/block_bus_test.cpp
// Source  ours: the source's cores share a memory.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_bus_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_bus.
class block_bus_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_core, a bit each
  in_port<BlockCores> word_valid_i{"word_valid_i"};
  out_port<BlockCores> word_ready_o{"word_ready_o"};
  out_port<BlockIndexBits> core_o{"core_o"};
  // write_buffer
  out_port<1> bus_valid_o{"bus_valid_o"};
  in_port<1> bus_ready_i{"bus_ready_i"};

  explicit block_bus_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_bus: its core behind the pins.
class block_bus : public block_bus_pins, public probed {
 public:
  using pins = block_bus_pins;
  static constexpr const char* unit_name = "block_bus";

  block_bus(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();

  const block_knobs knobs_;
  block_bus_core core_;
  bool asleep_ = true;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
