// block_shade: light and highlight of a hit, and the ray that leaves it.
//
// What    point = position + dir * distance; normal = unit of point - centre; lit = unit of
//         light - point; diffuse = max(normal * lit, 0); s = max(dir * (lit - normal * 2 diffuse),
//         0), squared specular_squarings times; colour = base * diffuse + s, s in all three
//         channels; direction = dir - normal * 2 (dir * normal). No division, no weight: every pass
//         counts fully.
// Size    3 multipliers 32 x 32, one vector operation a clock; the unit vectors are
//         block_normalise's.
// Cycles  9 + specular_squarings + two of block_normalise. start_i is looked at when idle, and that
//         clock makes the point; done_o in the last one. Inputs stay from start to done.
//         normalise_o stays 1 until unit_done_i, for each of the two.
// Comb    dir_i, distance_i, base_*_i -> direction_o (they share the multipliers); centre_i,
//         light_i -> v_o.
// Stall   waits for unit_done_i.
// Reset   rst_ni = 0: idle. All other registers are without reset.
// Knobs   specular_squarings, 0..6: parameter SpecularSquarings.
// Twin    rtl/block/block_shade.sv
// Test    tests/block/block_shade_test.cpp
// Source  article "The Integer Raytracer".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_shade_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_shade.
class block_shade_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_core
  in_port<1> start_i{"start_i"};
  axes_in<BlockBits> position_i{"position", "_i"};  // signed, the ray's start
  axes_in<BlockBits> dir_i{"dir", "_i"};            // signed
  in_port<BlockBits> distance_i{"distance_i"};      // signed
  axes_in<BlockBits> centre_i{"centre", "_i"};      // signed
  axes_in<BlockBits> light_i{"light", "_i"};        // signed
  in_port<BlockBits> base_red_i{"base_red_i"};      // the sphere's colour
  in_port<BlockBits> base_green_i{"base_green_i"};
  in_port<BlockBits> base_blue_i{"base_blue_i"};
  axes_out<BlockBits> point_o{"point", "_o"};          // signed
  axes_out<BlockBits> direction_o{"direction", "_o"};  // signed; 0 but with done_o
  out_port<BlockBits> colour_red_o{"colour_red_o"};
  out_port<BlockBits> colour_green_o{"colour_green_o"};
  out_port<BlockBits> colour_blue_o{"colour_blue_o"};
  out_port<1> done_o{"done_o"};
  // block_normalise
  out_port<1> normalise_o{"normalise_o"};
  axes_out<BlockBits> v_o{"v", "_o"};       // signed
  axes_in<BlockBits> unit_i{"unit", "_i"};  // signed
  in_port<1> unit_done_i{"unit_done_i"};

  explicit block_shade_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_shade: its core behind the pins.
class block_shade : public block_shade_pins, public probed {
 public:
  using pins = block_shade_pins;
  static constexpr const char* unit_name = "block_shade";

  block_shade(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  block_shade_core::inputs inputs() const;
  void seq();
  void comb();

  const block_knobs knobs_;
  block_shade_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
