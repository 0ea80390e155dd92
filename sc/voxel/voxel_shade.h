// voxel_shade: the colour of a pixel from where its ray ended.
//
// What    Sky: red, green, blue = VoxelSky* + (15 - slope) * VoxelSky*Step; slope = direction_z_i
//         >> 12 clamped to 0..15, with sky = plain 7. A limited ray with debug_limits: magenta,
//         0xff00ff of the outer limit, 0x7f007f of the inner. All others: of palette entry
//         material * 16 + height * 16 / SizeZ, a power of two. z is that of the ray's end in whole
//         units. The upper solid is shown if z >= low, middle < high, and z >= middle, of a ray
//         that does not go down z + 1 >= middle; height is the cell of the solid nearest to z. With
//         shading = slope each channel is taken l / 16 times, rounded down, l = clamp(10 - 2 (east
//         - west) - (north - south), 2, 15): high of the four columns beside if the upper solid is
//         shown, else low. East is x + 1, north y + 1. Then, with shadowed_i, each channel >> 1.
// Size    a palette of 128 x 24 bits; three multipliers 8 x 4, two for addresses.
// Cycles  take_i = 1, in the last clock of the picture's ray: kind, end and column, data_i, are
//         taken at its end. shade_i = 1, in the pixel's last clock of rays, with take_i or later:
//         begins, if idle. Reads of columns, 2 + MemoryClocks clocks each: read_o = 1 in the first,
//         data_i is taken in the last: with leaf = voxel the hit's own column; with shading =
//         slope east, west, north, south; none for sky and magenta. Then done_o = 1 with colour_o,
//         until put_ready_i = 1, at least a clock: idle again. In all 1 clock, 13 with slope, and 3
//         more with leaf = voxel, MemoryClocks = 1; in closed form: voxel_shade_pixel().
//         palette_write_i writes an entry at the end of any clock.
// Comb    leaf_read_i, leaf_address_i -> read_o, address_o: what voxel_leaf reads passes while no
//         own read is under way; direction_z_i -> colour_o.
// Stall   direction_z_i must be held from shade_i until idle. done_o and colour_o hold.
// Reset   rst_ni = 0: idle. Other registers keep what they have; all 0 at power-up.
// Knobs   leaf, shading, sky, debug_limits, memory_clocks and the world's: parameters Leaf,
//         Shading, Sky, DebugLimits, MemoryClocks, SizeX, SizeY, SizeZ.
// Twin    rtl/voxel/voxel_shade.sv
// Test    tests/voxel/voxel_shade_test.cpp
// Source  article "Termination", "Future work"; slope and palette are beyond it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_shade_core.h"

namespace racebeam {

/// Pins of voxel_shade.
class voxel_shade_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Host
  in_port<1> palette_write_i{"palette_write_i"};
  in_port<VoxelPaletteBits> palette_index_i{"palette_index_i"};
  in_port<VoxelColourBits> palette_colour_i{"palette_colour_i"};
  // voxel_scan
  in_port<1> take_i{"take_i"};
  in_port<1> shade_i{"shade_i"};
  in_port<1> shadowed_i{"shadowed_i"};  // with shade_i: the light does not reach it
  // voxel_walker
  in_port<VoxelKindBits> kind_i{"kind_i"};
  axes_in<VoxelPositionBits> hit_i{"hit", "_i"};  // signed
  // voxel_camera
  in_port<VoxelDirectionBits> direction_z_i{"direction_z_i"};  // signed
  // voxel_leaf
  in_port<1> leaf_read_i{"leaf_read_i"};
  in_port<VoxelColumnBits> leaf_address_i{"leaf_address_i"};
  // column_memory
  out_port<1> read_o{"read_o"};
  out_port<VoxelColumnBits> address_o{"address_o"};
  in_port<VoxelMemoryBits> data_i{"data_i"};
  // voxel_scan
  out_port<1> done_o{"done_o"};
  out_port<VoxelColourBits> colour_o{"colour_o"};
  // write_buffer
  in_port<1> put_ready_i{"put_ready_i"};

  explicit voxel_shade_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_shade: its core behind the pins.
class voxel_shade : public voxel_shade_pins, public probed {
 public:
  using pins = voxel_shade_pins;
  static constexpr const char* unit_name = "voxel_shade";

  voxel_shade(const sc_core::sc_module_name& name, const voxel_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_shade_core::inputs inputs() const;

  const voxel_knobs knobs_;
  voxel_shade_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
