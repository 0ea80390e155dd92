// block_convert: numbers of a scene, floats to 12.20, and what follows from those of a sphere.
//
// What    valid_i and ready_o take a float at the end of the clock: f2i(float), to units of 2^-14,
//         ties to even, for what is below 256; 0 beyond. With fraction_bits below 20 the low
//         20 - fraction_bits bits are 0. A centre, radius or colour goes to block_spheres in the
//         same clock (write_o, field_o, index_o, fixed_o; eye_k_o is the eye's component of a
//         centre's axis, else 0). Eye and light are kept, and the screen: start_o, the place of the
//         first pixel, is
//         (-width / 2 - eye.x, height / 2 - eye.y, -eye.z), halves rounded down.
//         After BlockBlue, which comes last of a sphere, three clocks without ready_o: the square
//         of the radius is written as BlockRadius2; the norm of eye - centre is made; their
//         difference is written as BlockRv.
// Size    3 multipliers 32 x 32.
// Cycles  a number a clock, 10 clocks a sphere.
// Comb    valid_i, float_i, field_i, index_i -> write_o, field_o, index_o, fixed_o, eye_k_o.
// Stall   ready_o.
// Reset   rst_ni = 0: ready; eye, light, width and height 0. What is of a sphere is without reset.
// Knobs   fraction_bits, 12..20: parameter FractionBits.
// Twin    rtl/block/block_convert.sv
// Test    tests/block/block_convert_test.cpp
// Source  article "Integers".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_convert_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_convert.
class block_convert_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Host
  in_port<1> valid_i{"valid_i"};
  in_port<32> float_i{"float_i"};              // its bits
  in_port<BlockFieldBits> field_i{"field_i"};  // block_field
  in_port<BlockIndexBits> index_i{"index_i"};  // of the sphere
  out_port<1> ready_o{"ready_o"};
  // block_spheres
  out_port<1> write_o{"write_o"};
  out_port<BlockFieldBits> field_o{"field_o"};
  out_port<BlockIndexBits> index_o{"index_o"};
  out_port<BlockBits> fixed_o{"fixed_o"};  // signed
  out_port<BlockBits> eye_k_o{"eye_k_o"};  // signed
  // block_core
  axes_out<BlockBits> eye_o{"eye", "_o"};      // signed
  axes_out<BlockBits> light_o{"light", "_o"};  // signed
  axes_out<BlockBits> start_o{"start", "_o"};  // signed

  explicit block_convert_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_convert: its core behind the pins.
class block_convert : public block_convert_pins, public probed {
 public:
  using pins = block_convert_pins;
  static constexpr const char* unit_name = "block_convert";

  block_convert(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  block_convert_core::inputs inputs() const;
  void seq();
  void comb();

  const block_knobs knobs_;
  block_convert_core core_;
  bool asleep_ = true;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
