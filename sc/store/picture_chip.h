// picture_chip: what wired chips have in common that draw into a frame store: the raster, the frame
// store and the screen's pins. An engine's chip has its tracer besides.
//
// A wire carries the name of the port that drives it, without its suffix. Instances are named
// u_<unit>. The only logic of its own: `sync`, hsync or vsync is low, and `blank`, no visible
// pixel. The tracer's side of u_write_buffer, its reset among it, is the engine's to bind. In RTL
// the same units are wired in rtl/store/frame_store.sv.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sc/base/wired_chip.h"
#include "sc/store/frame_memory.h"
#include "sc/store/frame_scanout.h"
#include "sc/store/store_arbiter.h"
#include "sc/store/store_counters.h"
#include "sc/store/write_buffer.h"
#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "sc/swap/unit_maker.h"
#include "sc/video/vga_timing.h"

namespace racebeam {

class picture_chip : public wired_chip {
 public:
  // Pins
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // The monitor
  out_port<1> hsync_no{"hsync_no"}, vsync_no{"vsync_no"};
  out_port<DacBits> red_o{"red_o"}, green_o{"green_o"}, blue_o{"blue_o"};

  video_pins video() const override { return {DacBits, store_knobs_.group_words()}; }
  /// The pins above; the engine's chip binds its own.
  void connect(const wired_chip::pins& bench) override;
  /// Nothing in the write buffer: the frame store gets black, and counting begins anew.
  virtual void begin_picture() { u_frame_memory.clear(); }
  /// Words are on their way to the frame store.
  bool storing() const { return take_valid.read() || (delays_ && delays_->busy()); }
  /// The frame store, by address; a picture is all in it when storing() is false again.
  const std::vector<std::uint64_t>& memory() const { return u_frame_memory.words(); }

  // vga_timing
  wire<3> speed{"speed"};  // 0: nothing drives it
  wire<11> x2{"x2"};
  wire<10> y{"y"};
  wire<1> hsync_n{"hsync_n"}, vsync_n{"vsync_n"}, active{"active"}, h_active{"h_active"};
  wire<1> consume{"consume"}, line_end{"line_end"}, active_start{"active_start"};
  wire<1> frame_end{"frame_end"}, nav_line{"nav_line"};
  wire<1> sync{"sync"}, blank{"blank"};
  // The frame store
  wire<1> put_ready{"put_ready"}, take_valid{"take_valid"}, take_ready{"take_ready"};
  wire<StoreAddressBits> take_address{"take_address"}, read_address{"read_address"},
      mem_address{"mem_address"};
  wire<StoreDataBits> take_data{"take_data"}, mem_data{"mem_data"}, mem_read_data{"mem_read_data"};
  wire<8> fill{"fill"};
  wire<1> read{"read"}, mem_write{"mem_write"};

 private:
  const store_knobs store_knobs_;

 public:
  // Units
  const std::unique_ptr<vga_timing_pins> u_vga_timing;
  const std::unique_ptr<write_buffer_pins> u_write_buffer;
  const std::unique_ptr<store_arbiter_pins> u_store_arbiter;
  frame_memory u_frame_memory;
  const std::unique_ptr<frame_scanout_pins> u_frame_scanout;

 protected:
  const std::unique_ptr<channel_stalls> stalls_;  // nullptr: no channel stalls
  const std::unique_ptr<channel_delays> delays_;  // nullptr: no channel has registers

  /// `clocks_per_pixel`: of the raster. Throws RtlError.
  picture_chip(const sc_core::sc_module_name& name, const store_knobs& k, int clocks_per_pixel,
               const unit_maker& units);

  /// The frame store's wires of the present clock; `offered`: the tracer has a word.
  store_view stored(bool offered) const;

 private:
  void bind_raster();
  void bind_store();
  void follow_raster();
};

}  // namespace racebeam
