// sphere_host_link: takes the spheres of a picture from a CPU, and adds the light.
//
// What    n = sphere_i[7:4], the number of spheres, or table_entries - 1 if that is less. While
//         host_i, and loaded_o is 0, a rising edge of valid_i is an entry: a clock with valid_i = 1
//         that was not taken since valid_i was last 0. An edge that comes while the tracer is busy
//         waits, as long as valid_i is held, and is taken once. Entries of a picture are counted
//         from 0: entries 0 to n - 1 are spheres, written to index sphere_i[3:0]; entry n is the
//         light, written to index n from light_*_i: radius 2, radius2 4, inverse 2048, reflect 0,
//         colour 31/31/31, is_light 1; loaded_o comes with it. colour is {light, r, g, b} of 1, 5,
//         5, 5 bits. A sphere with an index above n is not written, but counted. n is taken
//         at each edge; a count beyond it is the light, too. Without a CPU: when host_i was 1 for
//         HostPatience clocks in all (loaded_o 0) and no edge was ever taken since reset, a scene
//         that is built in is written, an entry a clock, from then on at once in each picture,
//         until an edge is taken. reflect, radius; centre in whole units; colour r/g/b:
//           scene_i = 0   (-9,0,15) r 5 31/4/4, (9,0,15) r 5 4/31/4, (0,-9,20) r 5 4/4/31, each
//                         reflect 0x400; (0,8,10) r 4 6/6/6 reflect 0x800
//           scene_i = 1   (0,0,15) r 10 31/16/4 reflect 0x400
//         with radius2 = r * r and inverse = floor(4096 / r); n = 4 or 1 by the same limit.
//         An edge in the same clock goes first.
//         fault_o is 1 for a clock: for a sphere with an index above n; for an entry n (the light)
//         of a picture with sphere_i[7:4] above table_entries - 1; for valid_i that was 1, was not
//         taken, and is 0 again.
// Cycles  an entry that is taken at an edge of the clock has table_write_o = 1 in the next clock,
//         for one clock; loaded_o and fault_o likewise. Fields keep their values without a write.
//         The count of entries is 0 again when loaded_o falls.
// Comb    none; all outputs are registers.
// Stall   the CPU holds the fields while valid_i is 1.
// Reset   rst_ni = 0: all registers 0 (fields too); valid_i counts as not taken.
// Knobs   table_entries: parameter TableEntries.
// Twin    rtl/sphere/sphere_host_link.sv
// Test    tests/sphere/sphere_host_link_test.cpp
// Source  report "Communication between NIOS II and FPGA".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_host_link_core.h"

namespace racebeam {

/// Pins of sphere_host_link.
class sphere_host_link_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // The CPU
  in_port<8> sphere_i{"sphere_i"};   // {number of spheres, index of this one}
  in_port<16> color_i{"color_i"};    // {light, red, green, blue}
  in_port<SphereBits> x1_i{"x1_i"};  // signed
  in_port<SphereBits> y1_i{"y1_i"};  // signed
  in_port<SphereBits> z1_i{"z1_i"};  // signed
  in_port<UnitBits> reflect_i{"reflect_i"};
  in_port<UnitBits> radius_i{"radius_i"};
  in_port<SphereBits> r2_i{"r2_i"};
  in_port<UnitBits> r_inv_i{"r_inv_i"};
  in_port<1> valid_i{"valid_i"};
  // sphere_inputs
  axes_in<SphereBits> light_i{"light", "_i"};  // signed
  in_port<1> scene_i{"scene_i"};
  // sphere_tracer
  in_port<1> host_i{"host_i"};  // it waits for the table; the CPU's `done`
  out_port<1> loaded_o{"loaded_o"};
  // sphere_table
  out_port<1> table_write_o{"table_write_o"};
  out_port<SphereIndexBits> table_index_o{"table_index_o"};
  out_port<SphereIndexBits> table_last_o{"table_last_o"};  // n
  axes_out<SphereBits> table_centre_o{"table_centre", "_o"};
  out_port<UnitBits> table_radius_o{"table_radius_o"};
  out_port<SphereBits> table_radius2_o{"table_radius2_o"};
  out_port<UnitBits> table_inverse_o{"table_inverse_o"};
  out_port<UnitBits> table_reflect_o{"table_reflect_o"};
  out_port<SphereColourBits> table_red_o{"table_red_o"};
  out_port<SphereColourBits> table_green_o{"table_green_o"};
  out_port<SphereColourBits> table_blue_o{"table_blue_o"};
  out_port<1> table_is_light_o{"table_is_light_o"};
  // Counters
  out_port<1> fault_o{"fault_o"};

  explicit sphere_host_link_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_host_link: its core behind the pins.
class sphere_host_link : public sphere_host_link_pins, public probed {
 public:
  using pins = sphere_host_link_pins;
  static constexpr const char* unit_name = "sphere_host_link";

  sphere_host_link(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();

  const sphere_knobs knobs_;
  sphere_host_link_core core_;
};

}  // namespace racebeam
