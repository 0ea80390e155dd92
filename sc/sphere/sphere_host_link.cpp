// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_host_link.h"

namespace racebeam {

sphere_host_link::sphere_host_link(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : sphere_host_link_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sphere_host_link);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
}

void sphere_host_link::seq() {
  sphere_host_link_core::inputs in{};
  in.rst_n = rst_ni.value() != 0;
  in.cpu.valid = valid_i.value() != 0;
  in.host = host_i.value() != 0;
  if (core_.idle(in)) return;
  in.cpu.sphere = sphere_i.value();
  in.cpu.color = color_i.value();
  in.cpu.x1 = x1_i.signed_value();
  in.cpu.y1 = y1_i.signed_value();
  in.cpu.z1 = z1_i.signed_value();
  in.cpu.reflect = reflect_i.value();
  in.cpu.radius = radius_i.value();
  in.cpu.r2 = r2_i.value();
  in.cpu.r_inv = r_inv_i.value();
  in.light = light_i.signed_value();
  in.scene = scene_i.value() != 0;
  core_.clock(in, knobs_);
  const sphere_table_core::inputs& write = core_.write_q;
  loaded_o.drive(core_.loaded_q);
  fault_o.drive(core_.fault_q);
  table_write_o.drive(write.write);
  table_index_o.drive(write.index);
  table_last_o.drive(write.last);
  table_centre_o.drive(write.row.centre);
  table_radius_o.drive(write.row.radius);
  table_radius2_o.drive(write.row.radius2);
  table_inverse_o.drive(write.row.inverse);
  table_reflect_o.drive(write.row.reflect);
  table_red_o.drive(write.row.colour[0]);
  table_green_o.drive(write.row.colour[1]);
  table_blue_o.drive(write.row.colour[2]);
  table_is_light_o.drive(write.row.is_light);
}

}  // namespace racebeam
