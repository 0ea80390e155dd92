// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_shade.h"

namespace racebeam {

voxel_shade::voxel_shade(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_shade_pins(name), knobs_(k) {
  SC_HAS_PROCESS(voxel_shade);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << direction_z_i << leaf_read_i << leaf_address_i << clocked_;
}

voxel_shade_core::inputs voxel_shade::inputs() const {
  return {rst_ni.value() != 0,
          palette_write_i.value() != 0,
          palette_index_i.value(),
          palette_colour_i.value(),
          take_i.value() != 0,
          shade_i.value() != 0,
          shadowed_i.value() != 0,
          kind_i.value(),
          hit_i.signed_value(),
          direction_z_i.signed_value(),
          leaf_read_i.value() != 0,
          static_cast<std::uint32_t>(leaf_address_i.value()),
          static_cast<std::uint32_t>(data_i.value()),
          put_ready_i.value() != 0};
}

void voxel_shade::seq() {
  const voxel_shade_core::inputs in = inputs();
  if (core_.idle(in)) return;
  core_.clock(in, knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_shade::comb() {
  const voxel_shade_core::outputs o = core_.comb(inputs(), knobs_);
  read_o.drive(o.read);
  address_o.drive(static_cast<int>(o.address));
  done_o.drive(o.done);
  colour_o.drive(o.colour);
}

}  // namespace racebeam
