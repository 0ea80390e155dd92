// plane_table: the planes of a scene, in a read-only memory.
//
// What    plane `index_i`: normal . p + distance = 0, the normal pointing to the eye's side;
//         colour, reflectivity, checkerboard mask, and how far from the origin it goes along each
//         axis, if it is limited. Of a plane that the scene does not have everything is 0.
// Size    8 entries of 164 bits; no registers.
// Cycles  combinational.
// Comb    index_i -> all outputs but last_o and empty_o, which are constants of the scene.
// Stall   none.
// Reset   none.
// Scene   the RTL reads PlaneFile by $readmemh, a row for each of Planes planes (0..8; without a
//         file there are none). A row is one hexadecimal number of 44 digits, most significant
//         first, two's complement; `_` may stand between fields:
//           digits  3 x 6 normal   6 distance   3 x 2 colour (0..1f)   3 reflect   1 checker
//                   1 limited      3 x 3 limit (digits of 4 bits, 000 of one that is not limited)
// Twin    rtl/sphere/plane_table.sv
// Test    tests/sphere/plane_table_test.cpp
// Source  report "State Machine".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/sphere_scene.h"

namespace racebeam {

/// Pins of plane_table.
class plane_table_pins : public sc_core::sc_module {
 public:
  // sphere_tracer
  in_port<PlaneIndexBits> index_i{"index_i"};
  axes_out<SphereBits> normal_o{"normal", "_o"};  // signed, of length 1
  out_port<SphereBits> distance_o{"distance_o"};  // signed
  out_port<SphereColourBits> red_o{"red_o"};
  out_port<SphereColourBits> green_o{"green_o"};
  out_port<SphereColourBits> blue_o{"blue_o"};
  out_port<UnitBits> reflect_o{"reflect_o"};  // of 4096
  out_port<4> checker_o{"checker_o"};
  out_port<1> limited_o{"limited_o"};
  axes_out<UnitBits> limit_o{"limit", "_o"};  // whole units
  out_port<PlaneIndexBits> last_o{"last_o"};  // index of the last plane; 0 if there is none
  out_port<1> empty_o{"empty_o"};             // there is none

  explicit plane_table_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of plane_table. The tables must outlive it.
class plane_table : public plane_table_pins {
 public:
  using pins = plane_table_pins;
  static constexpr const char* unit_name = "plane_table";

  plane_table(const sc_core::sc_module_name& name, const sphere_tables& tables);

 private:
  void comb();

  const std::vector<plane_row>& planes_;
};

}  // namespace racebeam
