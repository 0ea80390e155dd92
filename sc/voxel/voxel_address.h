// voxel_address: where the bit of a voxel is in the memory of occupancy.
//
// What    word_o and bit_o of voxel (x_i, y_i, z_i) of level_i, as voxel_levels has them: the
//         world repeats along x and y, tiles follow each other along x, y, z, bits in a tile are
//         in Morton order. inside_o = 0 below and above the world; then the bit is that of z
//         modulo the level's side. A level_i that the world does not have is level 0.
// Size    wires, and an adder of the level's offset, if the world's sides are powers of two; else
//         constants times tile numbers, by adders, and sides that are taken off.
// Comb    all inputs -> all outputs.
// Stall   none.
// Reset   none: no registers.
// Knobs   the world's: parameters SizeX, SizeY, SizeZ, VoxelX, VoxelY, VoxelZ, Levels.
// Twin    rtl/voxel/voxel_address.sv
// Test    tests/voxel/voxel_address_test.cpp
// Source  article "Storage", "Fetch code".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_address_core.h"

namespace racebeam {

/// Pins of voxel_address.
class voxel_address_pins : public sc_core::sc_module {
 public:
  // voxel_walker
  in_port<VoxelCoordinateBits> x_i{"x_i"};  // signed
  in_port<VoxelCoordinateBits> y_i{"y_i"};  // signed
  in_port<VoxelCoordinateBits> z_i{"z_i"};  // signed
  in_port<VoxelLevelBits> level_i{"level_i"};
  // occupancy_memory
  out_port<VoxelWordBits> word_o{"word_o"};
  out_port<VoxelBitBits> bit_o{"bit_o"};
  // voxel_walker
  out_port<1> inside_o{"inside_o"};

  explicit voxel_address_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_address: its core behind the pins.
class voxel_address : public voxel_address_pins {
 public:
  using pins = voxel_address_pins;
  static constexpr const char* unit_name = "voxel_address";

  voxel_address(const sc_core::sc_module_name& name, const voxel_knobs& k);

 private:
  void comb();

  voxel_address_core core_;
};

}  // namespace racebeam
