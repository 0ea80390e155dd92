// column_memory: the columns of the world, a synchronous memory with one port, outside of the chip.
//
// What    in each clock it writes data_i to address_i if write_i is 1, else it reads if read_i is.
//         Word y * SizeX + x is column (x, y): low in bits 7..0, middle in 15..8, high in 23..16,
//         materials in 26..24 and 29..27. An address beyond them reads as 0; what is written there
//         is lost.
// Size    SizeX * SizeY words of 32 bits.
// Cycles  a word read is on data_o after memory_clocks clocks, and stays until the next read is
//         there; a read a clock. A word written is read from the next clock on.
// Comb    none.
// Stall   none.
// Reset   none; 0 at power-up.
// Knobs   memory_clocks, and the world's.
// Twin    none: model only.
// Test    tests/voxel/column_memory_test.cpp
// Source  article "Storage".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_memory_core.h"

namespace racebeam {

/// Pins of column_memory.
class column_memory_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // voxel_builder
  in_port<1> read_i{"read_i"};
  in_port<1> write_i{"write_i"};
  in_port<VoxelColumnBits> address_i{"address_i"};
  in_port<VoxelMemoryBits> data_i{"data_i"};
  // voxel_builder, voxel_leaf, voxel_shade
  out_port<VoxelMemoryBits> data_o{"data_o"};

  explicit column_memory_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of column_memory: its core behind the pins.
class column_memory : public column_memory_pins {
 public:
  using pins = column_memory_pins;
  static constexpr const char* unit_name = "column_memory";

  column_memory(const sc_core::sc_module_name& name, const voxel_knobs& k);

  /// All words, by address: what the bench sees of them, and may put there.
  const std::vector<std::uint32_t>& words() const { return core_.words_q; }
  std::vector<std::uint32_t>& words() { return core_.words_q; }

 private:
  void seq();

  voxel_memory_core core_;
  bool asleep_ = true;
};

}  // namespace racebeam
