// sphere_shader: colour of a hit, of a ray with its reflections, and of a pixel.
//
// What    Registers: colour (3 x 11 bits, of the last hit), sum (3 x 10, so far), weight (12),
//         light (1), and the alias buffer, 9 x 30 bits. A channel of the base is c = base << 5; if
//         dark_i, (base << 5) >> 2. At the end of a clock, by op_i:
//           ShadeHold   nothing
//           ShadeStart  sum := 0, weight := 0xfff, light := 0
//           ShadeLight  colour := 0x3ff each; light := 1 if direct_i and sub_i = 0
//           ShadeHalf   colour := c >> 1
//           ShadeLit    colour := ((fraction_i * c) >> 12) + (c >> 1)
//           ShadePlain  colour := c
//           ShadeAdd    sum := min(sum + ((colour * weight) >> 12), 0x3ff); weight := weight_o
//           ShadeStore  buffer[sub_i] := sum; sum := 0; weight := 0xfff; light := 0 if sub_i is the
//                       last sub-ray: 0, 4 or 8 with alias_i = 0, 1, 2 (3 is as 2); of sub_i 9 to
//                       15 nothing is kept in the buffer
//         weight_o = (weight * reflect_i) >> 12: the weight after an ShadeAdd.
//         word_o is what the pixel is if the present sub-ray is its last: with s_k = buffer[k] for
//         k below sub_i and s_k = sum for k = sub_i, each channel is the sum over k = 0 .. sub_i of
//         s_k >> h_k: h = 0 for alias_i = 0; 1 for k = 0, else 3 for alias_i = 1; 2 for k = 0, 4
//         for k = 1..4, 3 for k = 5..8 for alias_i = 2. Of k above 8 nothing is added. Channels are
//         taken modulo 2^10. word_o = {light, red, green, blue}, the top colour_bits bits of each
//         channel, in its low 1 + 3 * colour_bits bits; those above are 0.
// Size    4 multipliers 12 x 12; 346 register bits.
// Cycles  one operation a clock.
// Comb    reflect_i -> weight_o; sub_i, alias_i -> word_o.
// Stall   none.
// Reset   rst_ni = 0: colour, sum, light and buffer 0, weight 0xfff.
// Knobs   colour_bits: parameter ColourBits.
// Twin    rtl/sphere/sphere_shader.sv
// Test    tests/sphere/sphere_shader_test.cpp
// Source  report "State Machine", "Anti-Aliasing".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_shader_core.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Pins of sphere_shader.
class sphere_shader_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // sphere_tracer
  in_port<3> op_i{"op_i"};  // shader_op
  in_port<SphereColourBits> base_red_i{"base_red_i"};
  in_port<SphereColourBits> base_green_i{"base_green_i"};
  in_port<SphereColourBits> base_blue_i{"base_blue_i"};
  in_port<1> dark_i{"dark_i"};                 // the dark squares of a checkerboard
  in_port<UnitBits> fraction_i{"fraction_i"};  // of the light, of 4096
  in_port<UnitBits> reflect_i{"reflect_i"};    // of 4096
  in_port<1> direct_i{"direct_i"};             // not in a mirror
  in_port<4> sub_i{"sub_i"};
  out_port<UnitBits> weight_o{"weight_o"};
  // sphere_inputs
  in_port<2> alias_i{"alias_i"};
  // write_buffer
  out_port<StoreDataBits> word_o{"word_o"};  // {light, red, green, blue}

  explicit sphere_shader_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_shader: its core behind the pins.
class sphere_shader : public sphere_shader_pins, public probed {
 public:
  using pins = sphere_shader_pins;
  static constexpr const char* unit_name = "sphere_shader";

  sphere_shader(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void weigh();
  void mix();

  const sphere_knobs knobs_;
  sphere_shader_core core_;
};

}  // namespace racebeam
