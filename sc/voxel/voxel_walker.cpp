// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_walker.h"

namespace racebeam {

voxel_walker::voxel_walker(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_walker_pins(name), knobs_(k), core_(k) {
  SC_HAS_PROCESS(voxel_walker);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << inverse_i.x << inverse_i.y << inverse_i.z << sample_i << hit_i << position_i.x
            << position_i.y << position_i.z << reached_i << clocked_;
}

voxel_walker_core::inputs voxel_walker::inputs() const {
  const auto word = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  return {rst_ni.value() != 0,
          start_i.value() != 0,
          shadow_i.value() != 0,
          origin_i.signed_value(),
          light_i.signed_value(),
          direction_i.signed_value(),
          {word(inverse_i.x.value()), word(inverse_i.y.value()), word(inverse_i.z.value())},
          inside_i.value() != 0,
          bit_i.value(),
          word(data_i.value()),
          some_i.value() != 0,
          sample_i.value() != 0,
          hit_i.value() != 0,
          done_i.value() != 0,
          position_i.signed_value(),
          reached_i.value() != 0};
}

void voxel_walker::seq() {
  core_.clock(inputs(), knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_walker::comb() {
  const voxel_walker_core::outputs o = core_.comb(inputs(), knobs_);
  setup_o.drive(o.setup);
  ray_o.drive(core_.direction_q);
  from_o.drive(core_.origin_q);
  x_o.drive(o.voxel[0]);
  y_o.drive(o.voxel[1]);
  z_o.drive(o.voxel[2]);
  level_o.drive(o.level);
  read_o.drive(o.read);
  leaf_o.drive(o.leaf);
  at_o.drive(o.at);
  column_o.drive(o.column);
  t_o.drive(o.t);
  t_out_o.drive(o.t_out);
  step_o.drive(core_.leaf_step_q);
  outer_o.drive(o.outer);
  inner_o.drive(o.inner);
  ray_done_o.drive(o.ray_done);
  kind_o.drive(o.kind);
  hit_o.drive(o.hit);
  state_o.drive(core_.state_q);
}

}  // namespace racebeam
