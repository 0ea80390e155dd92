// block_normalise: the unit vector of a vector, by an estimate of the inverse root and Newton's
// steps.
//
// What    unit = v * x, x about 1 / |v|, bits 51..20 of each product. With aa = v * v (bits 51..20
//         of the sum): F = the bits of the float (aa[29:6]) * 2^-14; x is the float with the bits
//         0x5f3759df - (F >> 1) in units of 2^-14, to nearest, ties to even, << 6; of aa[29:6] = 0
//         it is 0x3759df << 6. Then newton_steps times x = x * (1.5 - x * x * (aa >> 1)). Two
//         steps: at most 2.9e-5 off for aa of 1/64..1, 2.4e-4 up to 512, 4.7e-4 up to 1024. Below
//         |v| = 1/16, aa < BlockSmallLength2, it is worthless: small_o is 1 in the second clock.
// Size    3 multipliers 32 x 32, one vector operation a clock.
// Cycles  3 + 3 * newton_steps: start_i is looked at when idle; that clock makes aa, the next one
//         the estimate, three a step of Newton's; done_o in the last one. v_i stays from start to
//         done. While start_i stays 1, the next one begins in the clock after done_o.
// Comb    v_i -> unit_o.
// Stall   none: started, it ends.
// Reset   rst_ni = 0: idle. aa_q, x_q and t_q are without reset.
// Knobs   newton_steps, 0..3: parameter NewtonSteps.
// Twin    rtl/block/block_normalise.sv
// Test    tests/block/block_normalise_test.cpp
// Source  article "Integers".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_normalise_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_normalise.
class block_normalise_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_core and block_shade
  in_port<1> start_i{"start_i"};
  axes_in<BlockBits> v_i{"v", "_i"};         // signed
  axes_out<BlockBits> unit_o{"unit", "_o"};  // signed; 0 but with done_o
  out_port<1> done_o{"done_o"};
  // For counters
  out_port<1> small_o{"small_o"};

  explicit block_normalise_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_normalise: its core behind the pins.
class block_normalise : public block_normalise_pins, public probed {
 public:
  using pins = block_normalise_pins;
  static constexpr const char* unit_name = "block_normalise";

  block_normalise(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();

  const block_knobs knobs_;
  block_normalise_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
