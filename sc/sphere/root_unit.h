// root_unit: square root of a 12.12 number, digit by digit.
//
// What    root_o = floor(sqrt(radicand_i * 2^12)): the root of a 12.12 number as 12.12, 18
//         significant bits. There are 22 digits: 4 zeros, 12 of the radicand, two bits each, and
//         6 more; root_bits_per_clock of them a clock. The last clock takes as many, too: more
//         zeros come before the first.
// Cycles  edge 1 sees start_i rise (it was 0 at the edge before); edge 2 loads radicand_i; then
//         ceil(22 / root_bits_per_clock) edges take digits, and the last of them writes root_o and
//         sets done_o. Six edges from start to done: start_i is 1 in clock t, at the end of which
//         edge 1 is, done_o from clock t + 6 on. Knob: 2 + ceil(22 / bits) edges.
// Comb    none; root_o and done_o are registers.
// Stall   radicand_i must be held up to edge 2. start_i stays 1 until done_o was seen. done_o goes
//         at the edge that samples start_i = 0, root_o stays. start_i that falls before done_o
//         gives the root up: nothing is written, the unit is idle again.
// Reset   rst_ni = 0: idle, root_o = 0, done_o = 0; start_i counts as having been 0.
// Knobs   root_bits_per_clock, 1..22: parameter RootBitsPerClock.
// Twin    rtl/sphere/root_unit.sv
// Test    tests/sphere/root_unit_test.cpp
// Source  report "Square Root".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/root_unit_core.h"

namespace racebeam {

/// Pins of root_unit.
class root_unit_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // sphere_tracer
  in_port<1> start_i{"start_i"};
  in_port<SphereBits> radicand_i{"radicand_i"};
  out_port<SphereBits> root_o{"root_o"};
  out_port<1> done_o{"done_o"};

  explicit root_unit_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of root_unit: its core behind the pins.
class root_unit : public root_unit_pins, public probed {
 public:
  using pins = root_unit_pins;
  static constexpr const char* unit_name = "root_unit";

  root_unit(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();

  const sphere_knobs knobs_;
  root_unit_core core_;
};

}  // namespace racebeam
