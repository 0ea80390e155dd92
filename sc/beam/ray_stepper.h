// ray_stepper: the ray directions at both ends of the interval, moved without a multiplier.
//
// What    dr1 is the direction of pixel i1, dr2 that of pixel idx2. dr2 moves by a power of two of
//         pixels: it adds floor(delta * size / 512) plus one bit of delta, chosen from the bits of
//         idx2 that change, so that no fraction bits need to be stored and dr2 = dr_0 + J(idx2)
//         whatever the order of steps. camera_unit uses the same adder to multiply.
// Size    dr1, dr2: 3 x 10 bits each; knob dr_bits 8..13, and the fraction bits stored. The ports
//         are 13 bits wide and carry the value sign-extended. delta and ddr are one bit wider.
// Cycles  one load, one external add or one step a clock; outputs are registers.
// Comb    none.
// Stall   holds when nothing is asked.
// Reset   none; camera_unit loads zero.
// Knobs   dr_bits; stepping = fraction stores stepping_fraction_bits in dr1 and dr2, fraction_dr2
//         in dr2 alone: of 9 the steps are exact, of fewer they round as without; bisection =
//         midpoint asks for sizes that are not powers of two, taken bit by bit in one clock.
// Twin    rtl/beam/ray_stepper.sv
// Test    tests/beam/ray_stepper_test.cpp
// Source  contract section 8; article "Stepping the dr vector" and its appendix.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// The extra term of a step of `size` (a power of two) from `idx2`, with `fraction` bits stored:
/// one bit of delta. With no bit left to choose (a step that wraps idx2) it is the highest, as in
/// a 2-state simulator.
[[gnu::always_inline]] inline int step_extra_bit(int delta, int size, bool neg, int idx2,
                                                 int fraction = 0) {
  const int word = (neg ? idx2 : ~idx2) & 1023 & ~(size - 1);
  const int bit = DdrFractionBits - 1 - fraction - (word ? __builtin_ctz(word) : 0);
  return bit >= 0 ? delta >> bit & 1 : 0;
}

/// Behaviour of ray_stepper. Registers hold signed values of dr_bits, above fraction bits.
struct ray_stepper_core {
  vec3 dr1_q{}, dr2_q{};
  vec3 fraction1_q{}, fraction2_q{};  // 0 unless the knobs have them stored

  struct inputs {
    bool load, load_zero;  // dr2 := 0 or dr1
    bool ext;              // add delta to dr2, per axis_mask and ext_sign
    int ext_sign, axis_mask;
    vec3 delta;
    bool copy_ext, copy_sub;  // dr1 := dr2
    bool step, neg;
    int step_size;  // pixels
    int idx2;       // before the step
    bool tracer_reset;
  };

  [[gnu::always_inline]] void clock(const inputs& in, const knobs& k) {
    const vec3 dr2 = dr2_q, fraction2 = fraction2_q;
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const bool masked_in = bit_of(in.axis_mask, a);
      if (in.load) {
        dr2_q[a] = in.load_zero ? 0 : dr1_q[a];
        fraction2_q[a] = in.load_zero ? 0 : fraction1_q[a];
      } else if (in.tracer_reset && in.ext) {
        if (masked_in)
          dr2_q[a] = wrap_signed(dr2_q[a] + (bit_of(in.ext_sign, a) ? -in.delta[a] : in.delta[a]),
                                 k.dr_bits);
      } else if (in.step && (!in.tracer_reset || masked_in)) {
        step(a, in, k);
      }
    }
    if (in.tracer_reset ? in.copy_ext : in.copy_sub) {
      dr1_q = dr2;
      if (k.dr1_fraction() > 0) fraction1_q = fraction2;
    }
  }

  bool operator==(const ray_stepper_core& other) const {
    return dr1_q == other.dr1_q && dr2_q == other.dr2_q && fraction1_q == other.fraction1_q &&
           fraction2_q == other.fraction2_q;
  }
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    const int bits1 = k.dr1_fraction(), bits2 = k.dr2_fraction();
    for (int a = 0; a < 3; ++a) {
      const std::string axis = element("g_axis", a);
      visit(axis + ".dr1_q", k.dr_bits + bits1,
            [this, a, bits1] { return dr1_q[a] * (1 << bits1) | fraction1_q[a]; });
      visit(axis + ".dr2_q", k.dr_bits + bits2,
            [this, a, bits2] { return dr2_q[a] * (1 << bits2) | fraction2_q[a]; });
    }
  }

 private:
  [[gnu::always_inline]] void step(int a, const inputs& in, const knobs& k) {
    if (k.bisection != BisectionMidpoint) {  // all sizes are powers of two
      jump(a, in.step_size, in.idx2, in, k);
      return;
    }
    int idx2 = in.idx2;
    int rest = in.step_size;
    do {
      const int size = rest & -rest;
      jump(a, size, idx2, in, k);
      idx2 = (in.neg ? idx2 - size : idx2 + size) & 1023;
      rest -= size;
    } while (rest);
  }
  [[gnu::always_inline]] void jump(int a, int size, int idx2, const inputs& in, const knobs& k) {
    const int delta = in.delta[a], stored = k.dr2_fraction();
    if (stored > 0) {
      const int from = dr2_q[a] * (1 << stored) | fraction2_q[a];
      const int sum = stepped(from, {delta, size, in.neg, idx2, stored});
      dr2_q[a] = wrap_signed(sum >> stored, k.dr_bits);
      fraction2_q[a] = sum & low_bits(stored);
      return;
    }
    const int move = (delta * size >> DdrFractionBits) + step_extra_bit(delta, size, in.neg, idx2);
    dr2_q[a] = wrap_signed(in.neg ? dr2_q[a] - move : dr2_q[a] + move, k.dr_bits);
  }
  // A call, so that it costs nothing where no fraction is stored, as in the chip.
  struct fraction_step {
    int delta, size;
    bool neg;
    int idx2, stored;
  };
  [[gnu::noinline]] static int stepped(int from, const fraction_step& s) {
    const int move = (s.delta * s.size >> (DdrFractionBits - s.stored)) +
                     step_extra_bit(s.delta, s.size, s.neg, s.idx2, s.stored);
    return s.neg ? from - move : from + move;
  }
};

/// Pins of ray_stepper.
class ray_stepper_pins : public sc_core::sc_module {
 public:
  // Clock; phase of the line
  in_port<1> clk_i{"clk_i"};
  in_port<1> tracer_reset_i{"tracer_reset_i"};  // camera_unit rules
  // camera_unit
  in_port<1> load_i{"load_i"};                  // dr2 := 0 or dr1
  in_port<1> load_zero_i{"load_zero_i"};        // 0
  in_port<1> ext_i{"ext_i"};                    // dr2 +- delta
  in_port<3> ext_sign_i{"ext_sign_i"};          // per axis, 1: subtract
  in_port<3> axis_mask_i{"axis_mask_i"};        // per axis, 1: takes part
  axes_in<DdrPortBits> delta_i{"delta", "_i"};  // signed; ddr once the tracer runs
  in_port<1> copy_ext_i{"copy_ext_i"};          // dr1 := dr2
  // subdivider
  in_port<1> step_i{"step_i"};
  in_port<1> neg_i{"neg_i"};               // step to the left
  in_port<11> step_size_i{"step_size_i"};  // pixels
  in_port<PixelBits> idx2_i{"idx2_i"};     // pixel of dr2 before the step
  in_port<1> copy_sub_i{"copy_sub_i"};     // dr1 := dr2
  // Ray directions
  axes_out<DrPortBits> dr1_o{"dr1", "_o"};  // signed
  axes_out<DrPortBits> dr2_o{"dr2", "_o"};  // signed

  explicit ray_stepper_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of ray_stepper: its core behind the pins.
class ray_stepper : public ray_stepper_pins, public probed {
 public:
  using pins = ray_stepper_pins;
  static constexpr const char* unit_name = "ray_stepper";

  ray_stepper(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();

  const knobs knobs_;
  ray_stepper_core core_;
};

}  // namespace racebeam
