// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_limits.h"

namespace racebeam {

voxel_limits::voxel_limits(const sc_core::sc_module_name& name) : voxel_limits_pins(name) {
  SC_HAS_PROCESS(voxel_limits);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << outer_i << inner_i << clocked_;
}

voxel_limits_core::inputs voxel_limits::inputs() const {
  return {start_i.value() != 0, outer_i.value() != 0, inner_i.value() != 0, max_outer_i.value(),
          max_inner_i.value()};
}

void voxel_limits::seq() {
  core_.clock(inputs());
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_limits::comb() { reached_o.drive(core_.reached(inputs())); }

}  // namespace racebeam
