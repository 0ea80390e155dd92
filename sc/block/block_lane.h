// block_lane: how a ray passes one sphere.
//
// What    With a from the sphere's centre to the ray's start, and the ray's direction dir:
//           secondary_i  b         d                    k_i
//           0            a * dir   b * b + k            radius^2 - a^2 in pass 0
//           1            b_q       b * b - a * a + k    radius^2
//         A later pass has both clocks, in this order. Dot products are bits 51..20 of the exact
//         sum, b * b bits 51..20; d is of 33 bits, of terms that are 32 each. The ray meets the
//         sphere if d > 0, at -b - root(d).
// Size    4 multipliers 32 x 32.
// Cycles  a clock for the first pass's sphere, two for a later one's.
// Comb    all inputs -> b_o, d_o.
// Stall   none.
// Reset   none: b_q takes b at the end of every clock with secondary_i = 0.
// Twin    rtl/block/block_lane.sv
// Test    tests/block/block_lane_test.cpp
// Source  article "The Integer Raytracer".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_lane_core.h"
#include "sc/block/codes.h"

namespace racebeam {

/// Pins of block_lane.
class block_lane_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // block_core
  in_port<1> secondary_i{"secondary_i"};   // the second clock of a later pass
  axes_in<BlockBits> a_i{"a", "_i"};       // signed
  axes_in<BlockBits> dir_i{"dir", "_i"};   // signed
  in_port<BlockBits> k_i{"k_i"};           // signed
  out_port<BlockBits> b_o{"b_o"};          // signed
  out_port<BlockDistanceBits> d_o{"d_o"};  // signed

  explicit block_lane_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_lane: its core behind the pins.
class block_lane : public block_lane_pins, public probed {
 public:
  using pins = block_lane_pins;
  static constexpr const char* unit_name = "block_lane";

  explicit block_lane(const sc_core::sc_module_name& name);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  block_lane_core::inputs inputs() const;
  void seq();
  void comb();

  block_lane_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
