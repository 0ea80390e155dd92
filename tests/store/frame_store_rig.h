// The units of the frame store wired as in a chip, behind vga_timing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/store/frame_memory.h"
#include "sc/store/frame_scanout.h"
#include "sc/store/store_arbiter.h"
#include "sc/store/write_buffer.h"
#include "sc/video/vga_timing.h"
#include "tests/store/store_twins.h"

namespace racebeam {

/// What the units are made of.
struct Models {
  template <class Unit>
  using of = Unit;
};
struct Twins {
  template <class Unit>
  using of = own_store_rtl<Unit>;
};

/// Its ports are the tracer's side; what the tests watch are wires.
template <class Kind>
class FrameStoreRig : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<1> put_valid_i{"put_valid_i"};
  in_port<StoreAddressBits> put_address_i{"put_address_i"};
  in_port<StoreDataBits> put_data_i{"put_data_i"};
  out_port<1> put_ready_o{"put_ready_o"};
  out_port<8> fill_o{"fill_o"};
  out_port<DacBits> red_o{"red_o"}, green_o{"green_o"}, blue_o{"blue_o"};
  out_port<1> hsync_no{"hsync_no"}, vsync_no{"vsync_no"};

  wire<1> take_valid{"take_valid"}, take_ready{"take_ready"}, read{"read"}, mem_write{"mem_write"};
  wire<StoreAddressBits> take_address{"take_address"}, read_address{"read_address"},
      mem_address{"mem_address"};
  wire<StoreDataBits> take_data{"take_data"}, write_data{"write_data"}, read_data{"read_data"};

  FrameStoreRig(const sc_core::sc_module_name& name, const store_knobs& k, int clocks_per_pixel)
      : sc_module(name),
        u_vga_timing("u_vga_timing", clocks_per_pixel),
        u_write_buffer("u_write_buffer", k),
        u_store_arbiter("u_store_arbiter", k),
        u_frame_memory("u_frame_memory", k),
        u_frame_scanout("u_frame_scanout", k) {
    bind_timing();
    bind_writer();
    bind_beam();
    SC_HAS_PROCESS(FrameStoreRig);
    SC_METHOD(times_to_write);
    sensitive << hsync_n << vsync_n << active;
  }

  vga_timing u_vga_timing;
  typename Kind::template of<write_buffer> u_write_buffer;
  typename Kind::template of<store_arbiter> u_store_arbiter;
  frame_memory u_frame_memory;
  typename Kind::template of<frame_scanout> u_frame_scanout;

 private:
  void times_to_write() {
    sync.write(!hsync_n.read() || !vsync_n.read());
    blank.write(!active.read());
  }

  void bind_timing() {
    auto& u = u_vga_timing;
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
  void bind_writer() {
    auto& u = u_write_buffer;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.put_valid_i(put_valid_i);
    u.put_address_i(put_address_i);
    u.put_data_i(put_data_i);
    u.put_ready_o(put_ready_o);
    u.take_valid_o(take_valid);
    u.take_address_o(take_address);
    u.take_data_o(take_data);
    u.take_ready_i(take_ready);
    u.fill_o(fill_o);
    auto& a = u_store_arbiter;
    a.read_i(read);
    a.read_address_i(read_address);
    a.sync_i(sync);
    a.blank_i(blank);
    a.take_valid_i(take_valid);
    a.take_address_i(take_address);
    a.take_data_i(take_data);
    a.take_ready_o(take_ready);
    a.mem_write_o(mem_write);
    a.mem_address_o(mem_address);
    a.mem_data_o(write_data);
  }
  void bind_beam() {
    auto& m = u_frame_memory;
    m.clk_i(clk_i);
    m.mem_write_i(mem_write);
    m.mem_address_i(mem_address);
    m.mem_data_i(write_data);
    m.mem_data_o(read_data);
    auto& u = u_frame_scanout;
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
    u.mem_data_i(read_data);
    u.red_o(red_o);
    u.green_o(green_o);
    u.blue_o(blue_o);
    u.hsync_no(hsync_no);
    u.vsync_no(vsync_no);
  }

  wire<3> speed{"speed"};
  wire<1> hsync_n{"hsync_n"}, vsync_n{"vsync_n"}, active{"active"}, h_active{"h_active"},
      consume{"consume"}, line_end{"line_end"}, active_start{"active_start"},
      frame_end{"frame_end"}, nav_line{"nav_line"}, sync{"sync"}, blank{"blank"};
  wire<11> x2{"x2"};
  wire<10> y{"y"};
};

}  // namespace racebeam
