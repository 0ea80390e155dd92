// voxel_scan: takes the rays of a picture through its pixels, line by line, left to right.
//
// What    A pixel is a ray through the picture, with the knob shadows and kind_i = VoxelHit one to
//         the light too, and its colour, which goes to the write buffer: put_address_o = {row of 9
//         bits, column of 10}, put_data_o = colour_i. max_outer_o and max_inner_o are those of the
//         ray that starts next: shadow_outer and shadow_inner in RAY, else max_outer and max_inner.
//         shadow_o = 1 in RAY.
// Size    places of 9 and 10 bits.
// Cycles  IDLE: start_i = 1 begins a picture: camera_start_o and start_o in that clock, then RAY.
//         RAY lasts to ray_done_i = 1: take_o in that clock; and start_o, then SHADOW, of a ray
//         that needs another one, else shade_o, then SHADE. SHADOW lasts to ray_done_i = 1: shade_o
//         in that clock, and shadowed_o = 1 if kind_i = VoxelHit; then SHADE. SHADE: put_valid_o =
//         done_i. In the clock with put_ready_i = 1 too the pixel ends: next_pixel_o, or
//         next_line_o if it was the line's last, and start_o, then RAY; of the picture's last one
//         picture_done_o only, then IDLE. So a picture takes the clocks of its rays and of their
//         colours, and those in which the buffer lets it wait.
// Comb    start_i -> camera_start_o, start_o; ray_done_i, kind_i -> take_o, start_o, shade_o,
//         shadowed_o; done_i -> put_valid_o; done_i, put_ready_i -> next_pixel_o, next_line_o,
//         start_o, picture_done_o; colour_i -> put_data_o.
// Stall   waits for the rays, the colour and the buffer; start_i counts in IDLE only.
// Reset   rst_ni = 0: IDLE, places 0.
// Knobs   picture_width, picture_height, max_outer, max_inner, shadows, shadow_outer, shadow_inner:
//         parameters PictureWidth, PictureHeight, MaxOuter, MaxInner, Shadows, ShadowOuter,
//         ShadowInner.
// Twin    rtl/voxel/voxel_scan.sv
// Test    tests/voxel/voxel_scan_test.cpp
// Source  article "Algorithm", "Future work".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_scan_core.h"

namespace racebeam {

/// Pins of voxel_scan.
class voxel_scan_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Host
  in_port<1> start_i{"start_i"};
  out_port<1> picture_done_o{"picture_done_o"};
  // voxel_camera
  out_port<1> camera_start_o{"camera_start_o"};
  out_port<1> next_pixel_o{"next_pixel_o"};
  out_port<1> next_line_o{"next_line_o"};
  // voxel_walker, start_o to voxel_limits too
  out_port<1> start_o{"start_o"};
  out_port<1> shadow_o{"shadow_o"};  // with start_o
  in_port<1> ray_done_i{"ray_done_i"};
  in_port<VoxelKindBits> kind_i{"kind_i"};
  // voxel_limits, with start_o
  out_port<VoxelLimitBits> max_outer_o{"max_outer_o"};
  out_port<VoxelLimitBits> max_inner_o{"max_inner_o"};
  // voxel_shade
  out_port<1> take_o{"take_o"};
  out_port<1> shade_o{"shade_o"};
  out_port<1> shadowed_o{"shadowed_o"};  // with shade_o
  in_port<1> done_i{"done_i"};
  in_port<VoxelColourBits> colour_i{"colour_i"};
  // write_buffer
  out_port<1> put_valid_o{"put_valid_o"};
  out_port<StoreAddressBits> put_address_o{"put_address_o"};
  out_port<StoreDataBits> put_data_o{"put_data_o"};
  in_port<1> put_ready_i{"put_ready_i"};
  // For counters
  out_port<VoxelScanStateBits> state_o{"state_o"};

  explicit voxel_scan_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_scan: its core behind the pins.
class voxel_scan : public voxel_scan_pins, public probed {
 public:
  using pins = voxel_scan_pins;
  static constexpr const char* unit_name = "voxel_scan";

  voxel_scan(const sc_core::sc_module_name& name, const voxel_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();
  voxel_scan_core::inputs inputs() const;

  const voxel_knobs knobs_;
  voxel_scan_core core_;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
