// vector_unit: the three multipliers of the sphere tracer.
//
// What    lane k multiplies two signed 24-bit numbers, left_k * right_k, 48 bits, exactly:
//           op_i          left_k  right_k
//           VectorDot     a_k     b_k
//           VectorScale   a_k     s
//           VectorSquare  s       s        (so does op_i = 3)
//         Whatever the operation, product_k_o = bits 35..12 of lane k (floor), sum_o = the sum of
//         the three lanes modulo 2^48, square_o = lane x.
// Size    3 multipliers 24 x 24, no registers.
// Cycles  combinational.
// Comb    all inputs -> all outputs.
// Stall   none.
// Reset   none.
// Twin    rtl/sphere/vector_unit.sv
// Test    tests/sphere/vector_unit_test.cpp
// Source  report "State Machine".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit.h"
#include "sc/sphere/codes.h"

namespace racebeam {

/// Pins of vector_unit.
class vector_unit_pins : public sc_core::sc_module {
 public:
  // sphere_tracer
  in_port<2> op_i{"op_i"};                          // vector_op
  axes_in<SphereBits> a_i{"a", "_i"};               // signed
  axes_in<SphereBits> b_i{"b", "_i"};               // signed
  in_port<SphereBits> s_i{"s_i"};                   // signed
  axes_out<SphereBits> product_o{"product", "_o"};  // signed
  out_port<SphereSumBits> sum_o{"sum_o"};           // signed
  out_port<SphereSumBits> square_o{"square_o"};     // signed

  explicit vector_unit_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of vector_unit.
class vector_unit : public vector_unit_pins {
 public:
  using pins = vector_unit_pins;
  static constexpr const char* unit_name = "vector_unit";

  explicit vector_unit(const sc_core::sc_module_name& name);

 private:
  void comb();
};

}  // namespace racebeam
