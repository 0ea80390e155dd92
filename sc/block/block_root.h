// block_root: square root of a 3.20 number, made of the bits that it would have as a float.
//
// What    Let F be the bits of d_i * 2^-20 as a float (32 bits). root_o is the float whose bits are
//         (F >> 1) + 0x1fc00000, in units of 2^-20, to nearest, ties to even; 0 of 0. In gates: p
//         is the place of the leading one, 0 <= m < 1 the bits below it as a fraction. For p even
//         the root is 2^((p-20)/2) * (1 + m/2), for p odd 2^((p-21)/2) * (3/2 + m/2), rounded as
//         said. Never too small, never falling, at most 6.066 % too long, 2.14 % in the mean.
// Size    a priority encoder, a shifter, an adder of 23 bits; no registers.
// Cycles  combinational.
// Comb    d_i -> root_o.
// Stall   none.
// Reset   none.
// Twin    rtl/block/block_root.sv
// Test    tests/block/block_root_test.cpp
// Source  article "Integers".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit.h"
#include "sc/block/codes.h"

namespace racebeam {

/// Pins of block_root.
class block_root_pins : public sc_core::sc_module {
 public:
  // block_core
  in_port<BlockRootBits> d_i{"d_i"};
  out_port<BlockRootBits> root_o{"root_o"};

  explicit block_root_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_root: isqrt() behind the pins.
class block_root : public block_root_pins {
 public:
  using pins = block_root_pins;
  static constexpr const char* unit_name = "block_root";

  explicit block_root(const sc_core::sc_module_name& name);

 private:
  void comb();
};

}  // namespace racebeam
