// voxel_walker: takes a ray through the octree, from voxel to voxel.
//
// What    A ray stands in voxel (x, y, z) of a level at t. It looks whether anything is in it; if
//         not, it goes on to the border that it leaves by. t of a border at the whole coordinate c
//         of an axis is clamp(floor((c - origin) * inverse / 2^20), 0, 2^31), the difference 16.8
//         and negated for a direction below 0; 2^31 where the axis is parallel. SETUP: step 0 takes
//         origin and direction; if shadow_i was 1 with start_i, those are hit_*_q + 1.5 *
//         light_*_i, rounded down, and light_*_i. Step 17 enters the world: from above it (origin z
//         >= SizeZ) at t of plane SizeZ, or sky if direction z >= 0; else t = 0. Top level; the
//         voxel is that of position_*_i, from above not higher than the topmost. FETCH: occupied_q
//         = bit bit_i of data_i, 0 with inside_i = 0. DOWN: level - 1; the child is the far one
//         along an axis if t of the middle plane <= t (direction >= 0) or > t (below 0), parallel:
//         if origin >= the middle. EXIT: t_out = max(t, the smallest t of the three far borders),
//         axis the first such one of x, y, z. LEAF: voxel_leaf samples. MOVE: t = t_out; if there
//         is a larger voxel and the border is its border too, all coordinates >> 1, level + 1,
//         once, or with raise = all while that holds; then a voxel on along the axis. Then: above
//         the world and direction z >= 0: sky; below it, or the voxel's low side along the axis
//         beyond -2^15..2^15 - 1 units: LIMIT; else outer_o, and with reached_i LIMIT. LIMIT: reads
//         the column beneath position_*_i at t; but with direction z >= 0 the ray ends as sky,
//         without that state. The ray ends with ray_done_o = 1 for a clock: kind_o is a voxel_kind,
//         that after LIMIT the inner one if LEAF led there; else it is 0. hit_*_o is position_*_i:
//         that of the sample, of t in LIMIT; of t in EXIT with leaf = voxel, there with x and y not
//         outside of the voxel if something is in it. hit_*_q keeps it when a ray ends that is no
//         shadow's.
// Size    three multipliers 26 x 32 for borders; those of points are voxel_leaf's.
// Cycles  SETUP 18: step 1 has setup_o = 1. FETCH 1 + MemoryClocks: read_o = 1 in the first, data_i
//         is taken in the last. DOWN 1, EXIT 1, MOVE 1, LEAF as voxel_leaf takes, LIMIT 2 +
//         MemoryClocks: column_o = 1 in the first. at_o = 1 in step 17 of SETUP, in EXIT and LIMIT.
//         t_o is t, in step 17 that of the entry; t_out_o is t_out, from EXIT on. EXIT goes to
//         MOVE, but if something is in the voxel it has leaf_o = 1, and with some_i = 1 it goes to
//         LEAF; with leaf = voxel it has none, and ends the ray if t_out > t. In LEAF hit_i ends
//         the ray; sample_i without it has inner_o = 1, and with reached_i goes to LIMIT; else
//         done_i goes to MOVE. The clock after the last is the first of SETUP with start_i = 1,
//         else IDLE, which looks at start_i too. With group_fetch: in a FETCH at a level above 0
//         x_o, y_o, z_o and level_o are the voxel's first child. It takes the byte of data_i with
//         bit bit_i, occupied_q is 1 if anything is in it and inside_i = 1. In the FETCH after the
//         DOWN they are the voxel: it takes 1 clock, has read_o = 0, and looks at the bit of the
//         byte that the low bits of z, y, x name, and not at inside_i.
// Comb    position_*_i -> hit_*_o; inverse_*_i -> t_o, t_out_o, and with leaf = voxel ray_done_o,
//         kind_o; hit_i, sample_i -> inner_o; hit_i, sample_i, reached_i -> ray_done_o, kind_o.
// Stall   none but the memories' clocks.
// Reset   rst_ni = 0: IDLE. Other registers go on.
// Knobs   leaf, leaf_steps, raise, group_fetch, memory_clocks and the world's: parameters Leaf,
//         LeafSteps, Raise, GroupFetch, MemoryClocks, SizeZ, VoxelX, VoxelY, VoxelZ, Levels.
// Twin    rtl/voxel/voxel_walker.sv
// Test    tests/voxel/voxel_walker_test.cpp
// Source  article "Algorithm", "Termination", "Future work".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_walker_core.h"

namespace racebeam {

/// Pins of voxel_walker.
class voxel_walker_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // voxel_scan
  in_port<1> start_i{"start_i"};
  in_port<1> shadow_i{"shadow_i"};  // the ray goes from the last hit to the light
  // Host
  axes_in<VoxelPositionBits> origin_i{"origin", "_i"};  // signed
  axes_in<VoxelDirectionBits> light_i{"light", "_i"};   // signed
  // voxel_camera
  axes_in<VoxelDirectionBits> direction_i{"direction", "_i"};  // signed
  // voxel_setup
  out_port<1> setup_o{"setup_o"};
  axes_in<VoxelInverseBits> inverse_i{"inverse", "_i"};
  // voxel_setup, voxel_leaf
  axes_out<VoxelDirectionBits> ray_o{"ray", "_o"};   // signed
  axes_out<VoxelPositionBits> from_o{"from", "_o"};  // signed
  // voxel_address
  out_port<VoxelCoordinateBits> x_o{"x_o"};  // signed
  out_port<VoxelCoordinateBits> y_o{"y_o"};  // signed
  out_port<VoxelCoordinateBits> z_o{"z_o"};  // signed
  out_port<VoxelLevelBits> level_o{"level_o"};
  in_port<1> inside_i{"inside_i"};
  in_port<VoxelBitBits> bit_i{"bit_i"};
  // occupancy_memory
  out_port<1> read_o{"read_o"};
  in_port<VoxelMemoryBits> data_i{"data_i"};
  // voxel_leaf
  out_port<1> leaf_o{"leaf_o"};
  out_port<1> at_o{"at_o"};
  out_port<1> column_o{"column_o"};
  out_port<VoxelTBits> t_o{"t_o"};
  out_port<VoxelTBits> t_out_o{"t_out_o"};
  out_port<VoxelTBits> step_o{"step_o"};
  in_port<1> some_i{"some_i"};
  in_port<1> sample_i{"sample_i"};
  in_port<1> hit_i{"hit_i"};
  in_port<1> done_i{"done_i"};
  axes_in<VoxelPositionBits> position_i{"position", "_i"};  // signed
  // voxel_limits
  out_port<1> outer_o{"outer_o"};
  out_port<1> inner_o{"inner_o"};
  in_port<1> reached_i{"reached_i"};
  // voxel_scan, voxel_shade
  out_port<1> ray_done_o{"ray_done_o"};
  out_port<VoxelKindBits> kind_o{"kind_o"};
  axes_out<VoxelPositionBits> hit_o{"hit", "_o"};  // signed
  // For counters
  out_port<VoxelStateBits> state_o{"state_o"};

  explicit voxel_walker_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_walker: its core behind the pins.
class voxel_walker : public voxel_walker_pins, public probed {
 public:
  using pins = voxel_walker_pins;
  static constexpr const char* unit_name = "voxel_walker";

  voxel_walker(const sc_core::sc_module_name& name, const voxel_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_walker_core::inputs inputs() const;

  const voxel_knobs knobs_;
  voxel_walker_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
