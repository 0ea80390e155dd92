// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_leaf.h"

namespace racebeam {

voxel_leaf::voxel_leaf(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_leaf_pins(name), knobs_(k) {
  SC_HAS_PROCESS(voxel_leaf);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << at_i << fetch_i << t_from_i << t_to_i << step_i << origin_i.x << origin_i.y
            << origin_i.z << direction_i.x << direction_i.y << direction_i.z << data_i << clocked_;
}

voxel_leaf_core::inputs voxel_leaf::inputs() const {
  const auto word = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  return {rst_ni.value() != 0,        start_i.value() != 0, at_i.value() != 0,
          fetch_i.value() != 0,       stop_i.value() != 0,  word(t_from_i.value()),
          word(t_to_i.value()),       word(step_i.value()), origin_i.signed_value(),
          direction_i.signed_value(), word(data_i.value())};
}

void voxel_leaf::seq() {
  core_.clock(inputs(), knobs_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void voxel_leaf::comb() {
  const voxel_leaf_core::outputs o = core_.comb(inputs(), knobs_);
  read_o.drive(o.read);
  address_o.drive(static_cast<int>(o.address));
  some_o.drive(o.some);
  sample_o.drive(o.sample);
  hit_o.drive(o.hit);
  done_o.drive(o.done);
  t_o.drive(core_.t_q);
  samples_o.drive(core_.samples_q);
  position_o.drive(o.position);
}

}  // namespace racebeam
