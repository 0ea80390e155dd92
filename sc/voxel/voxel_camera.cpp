// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_camera.h"

namespace racebeam {

voxel_camera::voxel_camera(const sc_core::sc_module_name& name) : voxel_camera_pins(name) {
  SC_HAS_PROCESS(voxel_camera);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

voxel_camera_core::inputs voxel_camera::inputs() const {
  return {d00_i.signed_value(), dx_i.signed_value(),       dy_i.signed_value(),
          start_i.value() != 0, next_pixel_i.value() != 0, next_line_i.value() != 0};
}

void voxel_camera::seq() {
  core_.clock(inputs());
  direction_o.drive(core_.direction());
}

}  // namespace racebeam
