// block_pack: eight pixels into three words, one a colour.
//
// What    valid_i takes a pixel at the end of the clock: each word moves down by a byte, the new
// one
//         comes in at the top, so that of eight pixels the first lies in bits 7..0. full_o: with
//         the pixel of this clock there are eight; they are in the words from the next clock on.
// Size    3 words of 64 bits and a count of 3.
// Cycles  a pixel a clock.
// Comb    valid_i -> full_o.
// Stall   none: whoever packs reads the words before the next pixel.
// Reset   rst_ni = 0: words and count 0.
// Twin    rtl/block/block_pack.sv
// Test    tests/block/block_pack_test.cpp
// Source  article "The Integer Raytracer".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_pack_core.h"
#include "sc/block/codes.h"

namespace racebeam {

/// Pins of block_pack.
class block_pack_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_core
  in_port<1> valid_i{"valid_i"};
  in_port<8> red_i{"red_i"};
  in_port<8> green_i{"green_i"};
  in_port<8> blue_i{"blue_i"};
  out_port<64> red_o{"red_o"};
  out_port<64> green_o{"green_o"};
  out_port<64> blue_o{"blue_o"};
  out_port<1> full_o{"full_o"};

  explicit block_pack_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_pack: its core behind the pins.
class block_pack : public block_pack_pins, public probed {
 public:
  using pins = block_pack_pins;
  static constexpr const char* unit_name = "block_pack";

  explicit block_pack(const sc_core::sc_module_name& name);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();

  block_pack_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
