// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_scan.h"

namespace racebeam {

voxel_scan::voxel_scan(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_scan_pins(name), knobs_(k) {
  SC_HAS_PROCESS(voxel_scan);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << start_i << ray_done_i << kind_i << done_i << colour_i << put_ready_i << clocked_;
}

voxel_scan_core::inputs voxel_scan::inputs() const {
  return {rst_ni.value() != 0, start_i.value() != 0, ray_done_i.value() != 0,
          kind_i.value(),      done_i.value() != 0,  put_ready_i.value() != 0};
}

void voxel_scan::seq() {
  const voxel_scan_core::inputs in = inputs();
  if (core_.idle(in)) return;
  core_.clock(in, knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_scan::comb() {
  const voxel_scan_core::outputs o = core_.comb(inputs(), knobs_);
  picture_done_o.drive(o.picture_done);
  camera_start_o.drive(o.camera_start);
  next_pixel_o.drive(o.next_pixel);
  next_line_o.drive(o.next_line);
  start_o.drive(o.start);
  shadow_o.drive(o.shadow);
  max_outer_o.drive(o.max_outer);
  max_inner_o.drive(o.max_inner);
  take_o.drive(o.take);
  shade_o.drive(o.shade);
  shadowed_o.drive(o.shadowed);
  put_valid_o.drive(o.put_valid);
  put_address_o.drive(o.put_address);
  put_data_o.drive(static_cast<std::uint64_t>(colour_i.value()));
  state_o.drive(core_.state_q);
}

}  // namespace racebeam
