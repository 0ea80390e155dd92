// voxel_leaf: samples the columns along a ray, in a smallest voxel that something is in; and says
// where a ray is.
//
// What    Samples lie at t = t_from_i + step_i / 2 (rounded down), and every step_i from there,
//         while t < t_to_i. hit_o = 1 in the last clock of a sample whose point is in the solid of
//         its column: z < low, or middle <= z < high, in whole units. t_o is the t of the sample,
//         after one without a hit that of the next, modulo 2^32. position_*_o = origin + floor(t *
//         direction / 2^16), 16.8 modulo 2^16, at t_from_i with at_i = 1, else at t_o. samples_o
//         counts the samples since start_i that have ended without a hit, modulo 256. address_o is
//         the column of the position in the world that repeats, y * SizeX + x.
// Size    three multipliers 32 x 18; an adder of 33 bits for the next t.
// Cycles  start_i = 1 ends what goes on, sets t_o to the first t and samples_o to 0; with some_o =
//         1 the first sample begins in the next clock. A sample takes 2 + MemoryClocks clocks:
//         read_o = 1 in the first one; data_i is taken in the last one, in which sample_o = 1.
//         done_o = 1 if that was the voxel's last: a hit, or t_o + step_i >= t_to_i. Else the next
//         sample begins in the next clock, but with stop_i = 1 in that of sample_o none does.
//         fetch_i = 1 sets read_o too.
// Comb    t_from_i, t_to_i, step_i -> some_o = t_from_i + step_i / 2 < t_to_i; at_i, t_from_i,
//         origin_*_i, direction_*_i -> position_*_o, address_o; fetch_i -> read_o; data_i, t_to_i,
//         step_i, position -> hit_o, done_o. Sums of t have 33 bits.
// Stall   t_to_i, step_i, origin and direction must be held while a voxel is sampled; at_i = 1 is
//         for other clocks.
// Reset   rst_ni = 0: no sample goes on, and none begins. Other registers go on.
// Knobs   memory_clocks: parameter MemoryClocks; the world's SizeX, SizeY.
// Twin    rtl/voxel/voxel_leaf.sv
// Test    tests/voxel/voxel_leaf_test.cpp
// Source  article "Algorithm", step 4.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_leaf_core.h"

namespace racebeam {

/// Pins of voxel_leaf.
class voxel_leaf_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // voxel_walker
  in_port<1> start_i{"start_i"};
  in_port<1> at_i{"at_i"};
  in_port<1> fetch_i{"fetch_i"};
  in_port<VoxelTBits> t_from_i{"t_from_i"};
  in_port<VoxelTBits> t_to_i{"t_to_i"};
  in_port<VoxelTBits> step_i{"step_i"};
  axes_in<VoxelPositionBits> origin_i{"origin", "_i"};         // signed
  axes_in<VoxelDirectionBits> direction_i{"direction", "_i"};  // signed
  // voxel_limits
  in_port<1> stop_i{"stop_i"};
  // column_memory
  in_port<VoxelMemoryBits> data_i{"data_i"};
  out_port<1> read_o{"read_o"};
  out_port<VoxelColumnBits> address_o{"address_o"};
  // voxel_walker
  out_port<1> some_o{"some_o"};
  out_port<1> sample_o{"sample_o"};
  out_port<1> hit_o{"hit_o"};
  out_port<1> done_o{"done_o"};
  out_port<VoxelTBits> t_o{"t_o"};
  out_port<VoxelSampleBits> samples_o{"samples_o"};
  axes_out<VoxelPositionBits> position_o{"position", "_o"};  // signed

  explicit voxel_leaf_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_leaf: its core behind the pins.
class voxel_leaf : public voxel_leaf_pins, public probed {
 public:
  using pins = voxel_leaf_pins;
  static constexpr const char* unit_name = "voxel_leaf";

  voxel_leaf(const sc_core::sc_module_name& name, const voxel_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_leaf_core::inputs inputs() const;

  const voxel_knobs knobs_;
  voxel_leaf_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
