// block_root: square root of a 3.20 number.
//
// What    root = bits: let F be the bits of d_i * 2^-20 as a float (32 bits). root_o is the float
//         whose bits are (F >> 1) + 0x1fc00000, in units of 2^-20, to nearest, ties to even; 0 of
//         0. In gates: p is the place of the leading one, 0 <= m < 1 the bits below it as a
//         fraction. For p even the root is 2^((p-20)/2) * (1 + m/2), for p odd
//         2^((p-21)/2) * (3/2 + m/2), rounded as said. Never too small, never falling, at most
//         6.066 % too long, 2.14 % in the mean.
//         heron: r of the above, then (r + (d << 20) / r) / 2, both cut; 0 of 0. At most 0.174 %
//         too long.
//         exact: all digits, cut below 2^-20.
//         root_o is valid in the clock of done_o.
// Size    bits: a priority encoder, a shifter, an adder of 23 bits; registers that stay 0. heron:
//         three subtractors of 24 bits more; exact: two. step_q 4, remainder_q and found_q 24 bits.
// Cycles  bits: 1; heron: 9, three bits of the quotient a clock; exact: 12, two digits a clock.
//         start_i and d_i are held to the clock of done_o; the next root begins in the one after.
// Comb    d_i -> root_o.
// Stall   none.
// Reset   rst_ni = 0: step_q 0. The others are without reset.
// Knobs   root: parameter Root, 0 bits, 1 heron, 2 exact.
// Twin    rtl/block/block_root.sv
// Test    tests/block/block_root_test.cpp
// Source  article "Integers"; heron and exact are ours.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_root_core.h"
#include "sc/block/codes.h"

namespace racebeam {

/// Pins of block_root.
class block_root_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_core
  in_port<1> start_i{"start_i"};
  in_port<BlockRootBits> d_i{"d_i"};
  out_port<1> done_o{"done_o"};
  out_port<BlockRootBits> root_o{"root_o"};

  explicit block_root_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_root: its core behind the pins.
class block_root : public block_root_pins, public probed {
 public:
  using pins = block_root_pins;
  static constexpr const char* unit_name = "block_root";

  block_root(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();

  const block_knobs knobs_;
  block_root_core core_;
};

}  // namespace racebeam
