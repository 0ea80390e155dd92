// voxel_camera: the directions of a picture's rays, by sums.
//
// What    D24 = d00 + x * dx + y * dy for pixel (x, y), signed 2.24 modulo 2^32; direction_*_o is
//         bits 25..8 of it, 2.16.
// Size    two vectors, an adder each.
// Cycles  start_i goes to pixel (0, 0), next_line_i to the next line's first one, next_pixel_i to
//         the next in the line; of several the first counts. The direction is there from the next
//         clock on.
// Comb    none.
// Stall   d00, dx and dy must be held while a picture is drawn.
// Reset   none: start_i sets all.
// Twin    rtl/voxel/voxel_camera.sv
// Test    tests/voxel/voxel_camera_test.cpp
// Source  article "Analysis".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/voxel_camera_core.h"

namespace racebeam {

/// Pins of voxel_camera.
class voxel_camera_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // Host
  axes_in<VoxelCameraBits> d00_i{"d00", "_i"};  // signed
  axes_in<VoxelCameraBits> dx_i{"dx", "_i"};    // signed
  axes_in<VoxelCameraBits> dy_i{"dy", "_i"};    // signed
  // voxel_scan
  in_port<1> start_i{"start_i"};
  in_port<1> next_pixel_i{"next_pixel_i"};
  in_port<1> next_line_i{"next_line_i"};
  // voxel_walker
  axes_out<VoxelDirectionBits> direction_o{"direction", "_o"};  // signed

  explicit voxel_camera_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of voxel_camera: its core behind the pins.
class voxel_camera : public voxel_camera_pins, public probed {
 public:
  using pins = voxel_camera_pins;
  static constexpr const char* unit_name = "voxel_camera";

  explicit voxel_camera(const sc_core::sc_module_name& name);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  voxel_camera_core::inputs inputs() const;

  voxel_camera_core core_;
};

}  // namespace racebeam
