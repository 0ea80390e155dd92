// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_table.h"

namespace racebeam {

sphere_table::sphere_table(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : sphere_table_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sphere_table);
  SC_METHOD(seq);
  sensitive << table_write_i;
  dont_initialize();
  SC_METHOD(comb);
  sensitive << index_i << written_;
}

// Sleeps until something is to be written.
void sphere_table::seq() {
  if (clk_i->posedge() && table_write_i.value()) {
    core_.clock({true,
                 table_index_i.value(),
                 table_last_i.value(),
                 {table_centre_i.signed_value(),
                  table_radius_i.value(),
                  table_radius2_i.value(),
                  table_inverse_i.value(),
                  table_reflect_i.value(),
                  {table_red_i.value(), table_green_i.value(), table_blue_i.value()},
                  table_is_light_i.value() != 0}},
                knobs_);
    last_o.drive(core_.last_q);
    written_.notify(sc_core::SC_ZERO_TIME);
  }
  if (table_write_i.value()) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void sphere_table::comb() {
  const sphere_row& row = core_.row(index_i.value());
  centre_o.drive(row.centre);
  radius_o.drive(row.radius);
  radius2_o.drive(row.radius2);
  inverse_o.drive(row.inverse);
  reflect_o.drive(row.reflect);
  red_o.drive(row.colour[0]);
  green_o.drive(row.colour[1]);
  blue_o.drive(row.colour[2]);
  is_light_o.drive(row.is_light);
}

}  // namespace racebeam
