// voxel_builder: builds the octree of occupancy over a rectangle of columns; between the memories
// and who else reads them.
//
// What    start_i builds columns rect_x_low_i <= x < rect_x_high_i, y likewise, aligned outwards to
//         voxels. CLEAR: the bit of each voxel of level 0 := 0. Then FILL: each column sets the
//         bits of the voxels [z, z + VoxelZ) in which it has something: z < low, or z + VoxelZ >
//         middle and z < high and middle < high. Then UP, from level 1 to the top: the bit of each
//         voxel := whether one of its eight children is set, which are looked at in Morton order
//         until one is. A rectangle that is empty or goes beyond the world is not built. state_o is
//         a voxel_builder_state. columns_o: columns that FILL has done of this rectangle, or did of
//         the last one. IDLE: occupancy_memory is walk_*_i's, column_memory leaf_*_i's; with
//         host_write_i = 1 it is written at host_address_i instead. In other states it is nobody
//         else's: reads and writes are lost.
// Size    an adder or comparator for each place; addresses by a voxel_address of its own, and of a
//         column by adders.
// Cycles  start_i is looked at in IDLE; the next clock is the first of CLEAR. With r = 1 +
//         MemoryClocks: CLEAR r a voxel: a read, in the last clock of which it is written. FILL r a
//         column, 1 a voxel of it, r more for each that is set. UP r a child that is looked at, r
//         to write. z goes fastest, then x, then y. done_o = 1 in IDLE and in the last clock of a
//         build; start_i is not looked at in that clock.
// Comb    IDLE: walk_*_i -> occupancy_read_o, occupancy_address_o; leaf_*_i, host_*_i ->
// column_*_o;
//         else occupancy_data_i -> occupancy_data_o. done_o, columns_o, state_o: registers only.
// Stall   none; columns must not change while they are built.
// Reset   rst_ni = 0: IDLE, columns_o = 0. Other registers keep what they have.
// Knobs   memory_clocks and the world's: parameters MemoryClocks, SizeX, SizeY, SizeZ, VoxelX,
//         VoxelY, VoxelZ, Levels.
// Twin    rtl/voxel/voxel_builder.sv
// Test    tests/voxel/voxel_builder_test.cpp
// Source  article "Preparation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_builder_core.h"

namespace racebeam {

/// Pins of voxel_builder.
class voxel_builder_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Host
  in_port<VoxelRectangleBits> rect_x_low_i{"rect_x_low_i"};  // columns
  in_port<VoxelRectangleBits> rect_y_low_i{"rect_y_low_i"};
  in_port<VoxelRectangleBits> rect_x_high_i{"rect_x_high_i"};  // not included
  in_port<VoxelRectangleBits> rect_y_high_i{"rect_y_high_i"};
  in_port<1> start_i{"start_i"};
  in_port<1> host_write_i{"host_write_i"};
  in_port<VoxelColumnBits> host_address_i{"host_address_i"};
  out_port<1> done_o{"done_o"};
  // voxel_walker, voxel_address
  in_port<1> walk_read_i{"walk_read_i"};
  in_port<VoxelWordBits> walk_address_i{"walk_address_i"};
  // voxel_leaf, voxel_shade
  in_port<1> leaf_read_i{"leaf_read_i"};
  in_port<VoxelColumnBits> leaf_address_i{"leaf_address_i"};
  // column_memory; what is written there is the host's
  out_port<1> column_read_o{"column_read_o"};
  out_port<1> column_write_o{"column_write_o"};
  out_port<VoxelColumnBits> column_address_o{"column_address_o"};
  in_port<VoxelMemoryBits> column_data_i{"column_data_i"};
  // occupancy_memory
  out_port<1> occupancy_read_o{"occupancy_read_o"};
  out_port<1> occupancy_write_o{"occupancy_write_o"};
  out_port<VoxelWordBits> occupancy_address_o{"occupancy_address_o"};
  out_port<VoxelMemoryBits> occupancy_data_o{"occupancy_data_o"};
  in_port<VoxelMemoryBits> occupancy_data_i{"occupancy_data_i"};
  // For counters
  out_port<32> columns_o{"columns_o"};
  out_port<VoxelBuilderStateBits> state_o{"state_o"};

  explicit voxel_builder_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_builder: its core behind the pins.
class voxel_builder : public voxel_builder_pins, public probed {
 public:
  using pins = voxel_builder_pins;
  static constexpr const char* unit_name = "voxel_builder";

  voxel_builder(const sc_core::sc_module_name& name, const voxel_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_builder_core::inputs inputs() const;

  const voxel_knobs knobs_;
  voxel_builder_core core_;
  bool asleep_ = true;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
