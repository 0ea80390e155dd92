// sphere_table: the spheres of a picture, and the light as the last of them.
//
// What    table_write_i writes an entry at the end of the clock, and last_o, the index of the light
//         = the number of spheres. Reading is asynchronous. Entries from table_entries on do not
//         exist: writes to them are lost (last_o too), they read as 0. With fraction_bits below 12
//         the low 12 - fraction_bits bits of a centre are written as 0.
// Size    16 entries of 148 bits, and 4 bits for last_o.
// Cycles  a write is read from the next clock on.
// Comb    index_i -> all outputs but last_o.
// Stall   none.
// Reset   none; all 0 at power-up.
// Knobs   table_entries, fraction_bits: parameters TableEntries, FractionBits.
// Twin    rtl/sphere/sphere_table.sv
// Test    tests/sphere/sphere_table_test.cpp
// Source  report "Communication between NIOS II and FPGA".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_table_core.h"

namespace racebeam {

/// Pins of sphere_table.
class sphere_table_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // sphere_host_link
  in_port<1> table_write_i{"table_write_i"};
  in_port<SphereIndexBits> table_index_i{"table_index_i"};
  in_port<SphereIndexBits> table_last_i{"table_last_i"};
  axes_in<SphereBits> table_centre_i{"table_centre", "_i"};  // signed
  in_port<UnitBits> table_radius_i{"table_radius_i"};        // whole units
  in_port<SphereBits> table_radius2_i{"table_radius2_i"};    // its square, whole
  in_port<UnitBits> table_inverse_i{"table_inverse_i"};      // 4096 / radius
  in_port<UnitBits> table_reflect_i{"table_reflect_i"};      // of 4096
  in_port<SphereColourBits> table_red_i{"table_red_i"};
  in_port<SphereColourBits> table_green_i{"table_green_i"};
  in_port<SphereColourBits> table_blue_i{"table_blue_i"};
  in_port<1> table_is_light_i{"table_is_light_i"};
  // sphere_tracer
  in_port<SphereIndexBits> index_i{"index_i"};
  axes_out<SphereBits> centre_o{"centre", "_o"};  // signed
  out_port<UnitBits> radius_o{"radius_o"};
  out_port<SphereBits> radius2_o{"radius2_o"};
  out_port<UnitBits> inverse_o{"inverse_o"};
  out_port<UnitBits> reflect_o{"reflect_o"};
  out_port<SphereColourBits> red_o{"red_o"};
  out_port<SphereColourBits> green_o{"green_o"};
  out_port<SphereColourBits> blue_o{"blue_o"};
  out_port<1> is_light_o{"is_light_o"};
  out_port<SphereIndexBits> last_o{"last_o"};

  explicit sphere_table_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_table: its core behind the pins.
class sphere_table : public sphere_table_pins, public probed {
 public:
  using pins = sphere_table_pins;
  static constexpr const char* unit_name = "sphere_table";

  sphere_table(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();

  const sphere_knobs knobs_;
  sphere_table_core core_;
  sc_core::sc_event written_{"written"};
};

}  // namespace racebeam
