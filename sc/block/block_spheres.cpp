// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_spheres.h"

namespace racebeam {

block_spheres::block_spheres(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_spheres_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_spheres);
  SC_METHOD(seq);
  sensitive << write_i;
  dont_initialize();
  SC_METHOD(comb);
  sensitive << group_i << written_;
}

// Sleeps until something is to be written.
void block_spheres::seq() {
  if (clk_i->posedge() && write_i.value()) {
    core_.clock({true, field_i.value(), index_i.value(), static_cast<int>(value_i.signed_value()),
                 static_cast<int>(eye_k_i.signed_value())},
                knobs_);
    written_.notify(sc_core::SC_ZERO_TIME);
  }
  if (write_i.value()) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void block_spheres::comb() {
  const block_sphere& row = core_.row(group_i.value(), knobs_);
  pose_o.drive(row.pose);
  rv_o.drive(static_cast<std::uint64_t>(row.rv));
  centre_o.drive(row.centre);
  radius_o.drive(static_cast<std::uint64_t>(row.radius));
  radius2_o.drive(static_cast<std::uint64_t>(row.radius2));
  red_o.drive(static_cast<std::uint64_t>(row.colour[0]));
  green_o.drive(static_cast<std::uint64_t>(row.colour[1]));
  blue_o.drive(static_cast<std::uint64_t>(row.colour[2]));
}

}  // namespace racebeam
