// sphere_inputs: switches and keys of the board, and what they move: light, eye, screen.
//
// What    In every clock of the reset: eye, light and screen take the start values, rotz_o = 0, the
//         modes take the switches, planes_o = KEY2 pressed. In a clock with picture_done_i:
//         - each pair of switches moves a coordinate by 1.0 (4096), modulo 2^24: SW17 light +x,
//           SW16 light -x, SW15/14 light y, SW13/12 light z, SW11/10 eye x, SW9/8 eye y, SW7/6 eye
//           z. Both of a pair: neither moves, and a bit of rotz_o is 1: bit 5 for SW17/16 (z,
//           counter clockwise), 4 for SW15/14 (z, clockwise), 3 x ccw, 2 x cw, 1 y ccw, 0 for SW7/6
//           (y cw); bits 7 and 6 are 0;
//         - KEY0 held: screen += 1/16 (256); KEY1 held: screen -= 1/16; both: as it was;
//         - the modes take the switches: narrow_o = !SW5, scene_o = SW4, max_reflections_o =
//           SW3..2, alias_o = 2 (8x) if SW1, else 1 (4x) if SW0, else 0. planes_o stays.
//         Keys are 0 while pressed.
// Cycles  outputs but rst_no are registers: they change at the edge that ends a clock with
//         picture_done_i, or one of the reset.
// Comb    rst_ni, key_ni -> rst_no = rst_ni and KEY3 not pressed: the reset of all units behind it,
//         and of this one.
// Stall   none.
// Reset   rst_no = 0, as above.
// Scene   start values: parameters OriginX, OriginY, OriginZ, LightX, LightY, LightZ, Screen
//         (12.12, signed; by default 0, 0, -131072, 61440, 61440, -4096, 32768).
// Twin    rtl/sphere/sphere_inputs.sv
// Test    tests/sphere/sphere_inputs_test.cpp
// Source  report "Inputs".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/sphere_inputs_core.h"

namespace racebeam {

/// Pins of sphere_inputs.
class sphere_inputs_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  out_port<1> rst_no{"rst_no"};
  // Pins of the chip
  in_port<18> sw_i{"sw_i"};
  in_port<4> key_ni{"key_ni"};
  out_port<8> rotz_o{"rotz_o"};  // to the CPU: turns that are wanted
  // sphere_tracer
  in_port<1> picture_done_i{"picture_done_i"};
  axes_out<SphereBits> origin_o{"origin", "_o"};  // signed
  axes_out<SphereBits> light_o{"light", "_o"};    // signed
  out_port<2> max_reflections_o{"max_reflections_o"};
  out_port<2> alias_o{"alias_o"};  // 0: none, 1: 4x, 2: 8x
  out_port<1> narrow_o{"narrow_o"};
  out_port<1> planes_o{"planes_o"};
  // sphere_raygen
  out_port<SphereBits> screen_o{"screen_o"};  // signed
  // sphere_host_link
  out_port<1> scene_o{"scene_o"};  // built-in scene, if there is no CPU

  explicit sphere_inputs_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_inputs: its core behind the pins.
class sphere_inputs : public sphere_inputs_pins, public probed {
 public:
  using pins = sphere_inputs_pins;
  static constexpr const char* unit_name = "sphere_inputs";

  sphere_inputs(const sc_core::sc_module_name& name, const sphere_tables& tables);
  /// Back door: other registers.
  void deposit(const sphere_inputs_core& registers);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  void drive();

  const sphere_start start_;
  sphere_inputs_core core_;
};

}  // namespace racebeam
