// sphere_raygen: the direction of the ray through a point of the screen.
//
// What    W x H is 320 x 240 if narrow_i, else 512 x 480, with the knob wide 640 x 480. In 12.12:
//           sx = x * 4096 + ox * 2048, sy = y * 4096 + oy * 2048
//           direction_x = (sx >> 5) - W * 64 - (origin_x >> 5)
//           direction_y = (sy >> 5) - H * 64 - (origin_y >> 5)
//           direction_z = screen - (origin_z >> 5)
//         arithmetic shifts, modulo 2^24: the screen stands at z = 32 S with one unit a pixel, and
//         everything is divided by 32. (ox, oy) are half pixels, by sub-ray:
//           0 (0,0)   1 (-1,-1)  2 (-1,+1)  3 (+1,-1)  4 (+1,+1)
//           5 (-1,0)  6 (0,+1)   7 (0,-1)   8 (+1,0)   9..15 as 0
// Cycles  combinational.
// Comb    all inputs -> all outputs.
// Stall   none.
// Reset   none.
// Knobs   wide: parameter Wide, 0 or 1.
// Twin    rtl/sphere/sphere_raygen.sv
// Test    tests/sphere/sphere_raygen_test.cpp
// Source  report "State Machine", "Anti-Aliasing".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

/// Pins of sphere_raygen.
class sphere_raygen_pins : public sc_core::sc_module {
 public:
  // sphere_tracer
  in_port<PixelBits> x_i{"x_i"};
  in_port<PixelBits> y_i{"y_i"};
  in_port<4> sub_i{"sub_i"};
  axes_out<SphereBits> direction_o{"direction", "_o"};  // signed
  // sphere_inputs
  axes_in<SphereBits> origin_i{"origin", "_i"};  // signed
  in_port<SphereBits> screen_i{"screen_i"};      // signed
  in_port<1> narrow_i{"narrow_i"};

  explicit sphere_raygen_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_raygen.
class sphere_raygen : public sphere_raygen_pins {
 public:
  using pins = sphere_raygen_pins;
  static constexpr const char* unit_name = "sphere_raygen";

  sphere_raygen(const sc_core::sc_module_name& name, const sphere_knobs& k);

 private:
  void comb();

  const sphere_knobs knobs_;
};

}  // namespace racebeam
