// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_builder.h"

#include <utility>

namespace racebeam {

voxel_builder::voxel_builder(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_builder_pins(name), knobs_(k), core_(k) {
  SC_HAS_PROCESS(voxel_builder);
  SC_METHOD(seq);
  sensitive << start_i << rst_ni << rect_x_low_i << rect_y_low_i << rect_x_high_i << rect_y_high_i;
  SC_METHOD(comb);
  sensitive << host_write_i << host_address_i << walk_read_i << walk_address_i << leaf_read_i
            << leaf_address_i << occupancy_data_i << clocked_;
}

voxel_builder_core::inputs voxel_builder::inputs() const {
  const auto word = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto address = [](int value) { return static_cast<std::uint32_t>(value); };
  return {
      rst_ni.value() != 0,
      {rect_x_low_i.value(), rect_y_low_i.value(), rect_x_high_i.value(), rect_y_high_i.value()},
      start_i.value() != 0,
      host_write_i.value() != 0,
      address(host_address_i.value()),
      walk_read_i.value() != 0,
      address(walk_address_i.value()),
      leaf_read_i.value() != 0,
      address(leaf_address_i.value()),
      word(column_data_i.value()),
      word(occupancy_data_i.value())};
}

// While nothing is built it sleeps.
void voxel_builder::seq() {
  if (!std::exchange(asleep_, false)) {
    const voxel_builder_core::inputs in = inputs();
    core_.clock(in, knobs_);
    asleep_ = core_.idle(in);
    clocked_.notify(sc_core::SC_ZERO_TIME);
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

void voxel_builder::comb() {
  const voxel_builder_core::outputs o = core_.comb(inputs(), knobs_);
  done_o.drive(o.done);
  column_read_o.drive(o.column_read);
  column_write_o.drive(o.column_write);
  column_address_o.drive(static_cast<int>(o.column_address));
  occupancy_read_o.drive(o.occupancy_read);
  occupancy_write_o.drive(o.occupancy_write);
  occupancy_address_o.drive(static_cast<int>(o.occupancy_address));
  occupancy_data_o.drive(o.occupancy_data);
  columns_o.drive(core_.columns_q);
  state_o.drive(core_.state_q);
}

}  // namespace racebeam
