// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/video/vga_timing.h"

namespace racebeam {

vga_timing::vga_timing(const sc_core::sc_module_name& name, int clocks_per_pixel)
    : vga_timing_pins(name), clocks_per_pixel_(clocks_per_pixel) {
  SC_HAS_PROCESS(vga_timing);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << speed_i;
}

void vga_timing::seq() {
  core_.clock({rst_ni.value() != 0, speed_i.value()}, clocks_per_pixel_);
  comb();
}

void vga_timing::comb() {
  const auto o = core_.comb({rst_ni.value() != 0, speed_i.value()}, clocks_per_pixel_);
  x2_o.drive(o.x2);
  y_o.drive(o.y);
  hsync_no.drive(o.hsync_n);
  vsync_no.drive(o.vsync_n);
  active_o.drive(o.active);
  h_active_o.drive(o.h_active);
  consume_o.drive(o.consume);
  line_end_o.drive(o.line_end);
  active_start_o.drive(o.active_start);
  frame_end_o.drive(o.frame_end);
  nav_line_o.drive(o.nav_line);
}

}  // namespace racebeam
