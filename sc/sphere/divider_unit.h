// divider_unit: three divisions by one denominator, restoring, on magnitudes.
//
// What    quotient = numerator / denominator, towards zero; its low 24 bits, in two's complement.
//         Magnitudes are divided, the low 24 bits of the quotient's magnitude get the sign: minus
//         if the signs of numerator and denominator differ. Denominator 0: 0x7fffff, for a negative
//         numerator 0x800001. The numerator -2^35 has the magnitude 2^35, the denominator -2^23
//         the magnitude 2^23.
// Cycles  edge 1 sees start_i rise (it was 0 at the edge before), takes numerators and denominator
//         and divides its first ceil(36 / divide_clocks) bits; edge divide_clocks writes the
//         quotients and sets done_o. Five edges: start_i is 1 in clock t, done_o from clock t + 5.
// Comb    none; quotients and done_o are registers.
// Stall   start_i stays 1 until done_o was seen. done_o goes at the edge that samples start_i = 0,
//         the quotients stay. start_i that falls before done_o gives the division up: nothing is
//         written.
// Reset   rst_ni = 0: idle, quotients 0, done_o = 0; start_i counts as having been 0.
// Knobs   divide_clocks, 1..36: parameter DivideClocks.
// Twin    rtl/sphere/divider_unit.sv
// Test    tests/sphere/divider_unit_test.cpp
// Source  report "State Machine".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/divider_unit_core.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

/// Pins of divider_unit.
class divider_unit_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // sphere_tracer
  in_port<1> start_i{"start_i"};
  axes<in_port<NumeratorBits>> numerator_i{"numerator", "_i"};  // signed
  in_port<SphereBits> denominator_i{"denominator_i"};           // signed
  axes_out<SphereBits> quotient_o{"quotient", "_o"};            // signed
  out_port<1> done_o{"done_o"};

  explicit divider_unit_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of divider_unit: its core behind the pins.
class divider_unit : public divider_unit_pins, public probed {
 public:
  using pins = divider_unit_pins;
  static constexpr const char* unit_name = "divider_unit";

  divider_unit(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();

  const sphere_knobs knobs_;
  divider_unit_core core_;
};

}  // namespace racebeam
