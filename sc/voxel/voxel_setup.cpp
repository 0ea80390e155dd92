// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_setup.h"

namespace racebeam {

voxel_setup::voxel_setup(const sc_core::sc_module_name& name) : voxel_setup_pins(name) {
  SC_HAS_PROCESS(voxel_setup);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << direction_i.x << direction_i.y << direction_i.z << clocked_;
}

voxel_setup_core::inputs voxel_setup::inputs() const {
  return {rst_ni.value() != 0, start_i.value() != 0, direction_i.signed_value()};
}

void voxel_setup::seq() {
  core_.clock(inputs());
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_setup::comb() {
  const vec3 direction = direction_i.signed_value();
  inverse_o.x.drive(core_.inverse(0, direction));
  inverse_o.y.drive(core_.inverse(1, direction));
  inverse_o.z.drive(core_.inverse(2, direction));
  parallel_o.drive(voxel_setup_core::parallel(direction));
  done_o.drive(core_.done());
}

}  // namespace racebeam
