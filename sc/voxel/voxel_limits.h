// voxel_limits: how far a ray may still go.
//
// What    Two counters, of voxels that the ray moves to, outer, and of samples without a hit,
//         inner. reached_o = 1: the ray stops here, at a move with no voxel left, or at the last
//         sample.
// Size    two counters of 10 bits.
// Cycles  start_i sets both to max_*_i; outer_i and inner_i take one off, down to 0. start_i
//         counts before them.
// Comb    outer_i, inner_i -> reached_o = (outer_i and none is left) or (inner_i and at most one
//         is left).
// Stall   none.
// Reset   none: start_i sets all.
// Twin    rtl/voxel/voxel_limits.sv
// Test    tests/voxel/voxel_limits_test.cpp
// Source  article "Termination".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/voxel_limits_core.h"

namespace racebeam {

/// Pins of voxel_limits.
class voxel_limits_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // voxel_walker
  in_port<1> start_i{"start_i"};
  in_port<1> outer_i{"outer_i"};
  in_port<1> inner_i{"inner_i"};
  // voxel_scan
  in_port<VoxelLimitBits> max_outer_i{"max_outer_i"};
  in_port<VoxelLimitBits> max_inner_i{"max_inner_i"};
  // voxel_walker
  out_port<1> reached_o{"reached_o"};

  explicit voxel_limits_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_limits: its core behind the pins.
class voxel_limits : public voxel_limits_pins, public probed {
 public:
  using pins = voxel_limits_pins;
  static constexpr const char* unit_name = "voxel_limits";

  explicit voxel_limits(const sc_core::sc_module_name& name);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_limits_core::inputs inputs() const;

  voxel_limits_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
