// voxel_setup: the inverses of a direction's three components.
//
// What    inverse_*_o = floor(2^36 / |direction_*_i|), 12.20, at most 2^32 - 1; 0 of a component
//         that is parallel, |direction| < 16, whose bit of parallel_o is 1: x in bit 0.
// Size    three dividers, two digits a clock.
// Cycles  the clock with start_i = 1 is the first of 16; done_o = 1 in the last, and from the next
//         on inverse_*_o are whole, until start_i comes again. It is not looked at in the 15
//         clocks after it.
// Comb    direction_*_i -> parallel_o, inverse_*_o.
// Stall   direction_*_i must be held from start_i on, for as long as the inverses are used.
// Reset   rst_ni = 0: done_o = 0; the dividers wait for start_i.
// Twin    rtl/voxel/voxel_setup.sv
// Test    tests/voxel/voxel_setup_test.cpp
// Source  article "Algorithm".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/voxel_setup_core.h"

namespace racebeam {

/// Pins of voxel_setup.
class voxel_setup_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // voxel_walker
  in_port<1> start_i{"start_i"};
  axes_in<VoxelDirectionBits> direction_i{"direction", "_i"};  // signed
  axes_out<VoxelInverseBits> inverse_o{"inverse", "_o"};
  out_port<3> parallel_o{"parallel_o"};  // z, y, x
  out_port<1> done_o{"done_o"};

  explicit voxel_setup_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_setup: its core behind the pins.
class voxel_setup : public voxel_setup_pins, public probed {
 public:
  using pins = voxel_setup_pins;
  static constexpr const char* unit_name = "voxel_setup";

  explicit voxel_setup(const sc_core::sc_module_name& name);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_setup_core::inputs inputs() const;

  voxel_setup_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
