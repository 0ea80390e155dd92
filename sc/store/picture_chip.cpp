// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/picture_chip.h"

namespace racebeam {

picture_chip::picture_chip(const sc_core::sc_module_name& name, const store_knobs& k,
                           int clocks_per_pixel, const unit_maker& units)
    : wired_chip(name),
      store_knobs_(k),
      u_vga_timing(units.make<vga_timing>(clocks_per_pixel)),
      u_write_buffer(units.make<write_buffer>(k)),
      u_store_arbiter(units.make<store_arbiter>(k)),
      u_frame_memory("u_frame_memory", k),
      u_frame_scanout(units.make<frame_scanout>(k)),
      stalls_(channel_stalls::make(*this, clk_i)),
      delays_(channel_delays::make(*this, clk_i)) {
  bind_raster();
  bind_store();
  SC_HAS_PROCESS(picture_chip);
  SC_METHOD(follow_raster);
  sensitive << hsync_n << vsync_n << active;
}

void picture_chip::connect(const wired_chip::pins& bench) {
  clk_i(bench.clk);
  rst_ni(bench.rst_n);
  hsync_no(bench.hsync_n);
  vsync_no(bench.vsync_n);
  red_o(bench.red);
  green_o(bench.green);
  blue_o(bench.blue);
}

void picture_chip::follow_raster() {
  sync.write(!hsync_n.read() || !vsync_n.read());
  blank.write(!active.read());
}

store_view picture_chip::stored(bool offered) const {
  return {offered,     put_ready.read(), take_ready.read(), static_cast<int>(fill.read()),
          read.read(), mem_write.read(), frame_end.read()};
}

void picture_chip::bind_raster() {
  {
    auto& u = *u_vga_timing;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.speed_i(speed);
    u.hsync_no(hsync_n);
    u.vsync_no(vsync_n);
    u.x2_o(x2);
    u.y_o(y);
    u.active_o(active);
    u.h_active_o(h_active);
    u.consume_o(consume);
    u.line_end_o(line_end);
    u.active_start_o(active_start);
    u.frame_end_o(frame_end);
    u.nav_line_o(nav_line);
  }
  {
    auto& u = *u_frame_scanout;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.consume_i(consume);
    u.active_i(active);
    u.line_end_i(line_end);
    u.y_i(y);
    u.hsync_ni(hsync_n);
    u.vsync_ni(vsync_n);
    u.read_o(read);
    u.read_address_o(read_address);
    u.mem_data_i(mem_read_data);
    u.red_o(red_o);
    u.green_o(green_o);
    u.blue_o(blue_o);
    u.hsync_no(hsync_no);
    u.vsync_no(vsync_no);
  }
}

void picture_chip::bind_store() {
  {
    auto& u = *u_write_buffer;
    u.clk_i(clk_i);
    u.put_ready_o(put_ready);
    u.take_valid_o(take_valid);
    u.take_address_o(take_address);
    u.take_data_o(take_data);
    bind_channel(stalls_, u.take_ready_i, delayed(delays_, u.take_ready_i, take_ready));
    u.fill_o(fill);
  }
  {
    auto& u = *u_store_arbiter;
    u.read_i(read);
    u.read_address_i(read_address);
    u.sync_i(sync);
    u.blank_i(blank);
    bind_channel(stalls_, u.take_valid_i, delayed(delays_, u.take_valid_i, take_valid));
    u.take_address_i(delayed(delays_, u.take_address_i, take_address));
    u.take_data_i(delayed(delays_, u.take_data_i, take_data));
    u.take_ready_o(take_ready);
    u.mem_write_o(mem_write);
    u.mem_address_o(mem_address);
    u.mem_data_o(mem_data);
  }
  {
    auto& u = u_frame_memory;
    u.clk_i(clk_i);
    u.mem_write_i(mem_write);
    u.mem_address_i(mem_address);
    u.mem_data_i(mem_data);
    u.mem_data_o(mem_read_data);
  }
}

}  // namespace racebeam
