// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/plane_table.h"

#include "sc/sphere/sphere_table_core.h"

namespace racebeam {

plane_table::plane_table(const sc_core::sc_module_name& name, const sphere_tables& tables)
    : plane_table_pins(name), planes_(tables.planes) {
  SC_HAS_PROCESS(plane_table);
  SC_METHOD(comb);
  sensitive << index_i;
}

void plane_table::comb() {
  const plane_row& row = plane_table_core::row(planes_, index_i.value());
  normal_o.drive(row.normal);
  distance_o.drive(row.distance);
  red_o.drive(row.colour[0]);
  green_o.drive(row.colour[1]);
  blue_o.drive(row.colour[2]);
  reflect_o.drive(row.reflect);
  checker_o.drive(row.checker);
  limited_o.drive(row.limited);
  limit_o.drive(row.limit);
  last_o.drive(plane_table_core::last(planes_));
  empty_o.drive(planes_.empty());
}

}  // namespace racebeam
