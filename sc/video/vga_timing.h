// vga_timing: raster counters, syncs and the events that start lines and frames.
//
// What    800 x 525 pixels, two clocks a pixel: 1600 clocks a line, 840,000 a frame. A line is
//         front porch 16, sync 96, back porch 48, active 640 pixels, in that order; a frame is
//         back porch 33, active 480, front porch 10, sync 2 lines. h_pos runs -480..319, y
//         -273..251. Speed pins shorten the pixels whose h_pos[3:0] is in a list to one clock:
//         bit 0: 7, 15; bit 1: 5, 9, 11, 13; bit 2: 6, 8, 10.
// Size    26 register bits.
// Cycles  every output describes the clock it is on; consume and line_end are 1 in the last clock
//         of a pixel. vsync changes at the end of hsync, 224 clocks into a line.
// Comb    speed_i -> x2_o, consume_o, line_end_o, active_start_o, frame_end_o.
// Stall   none.
// Reset   c = 0 of y = -273; vs is not reset (0 at power-up).
// Knobs   clocks_per_pixel (x2 counts half pixels only at its default, 2).
// Twin    rtl/video/vga_timing.sv
// Test    tests/video/vga_timing_test.cpp
// Source  contract sections 5.1, 5.2, 6.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"

namespace racebeam {

/// Behaviour of vga_timing.
struct vga_timing_core {
  int h_region_q = 0;  // 0 front porch, 1 sync, 2 back porch, 3 active
  int h_pos_q = FirstPosition;
  int half_q = 0;      // clock within the pixel
  int v_region_q = 0;  // 0 back porch, 1 active, 2 front porch, 3 sync
  int v_pos_q = FirstLine;
  bool vs_q = false;

  struct inputs {
    bool rst_n;
    int speed;
  };
  struct outputs {
    int x2;
    int y;
    bool hsync_n, vsync_n, active, h_active;
    bool consume, line_end, active_start, frame_end, nav_line;
  };

  /// 1 in the last clock of a pixel.
  bool h_en(int speed, int clocks_per_pixel) const {
    static constexpr int short_pixels[3] = {1 << 7 | 1 << 15, 1 << 5 | 1 << 9 | 1 << 11 | 1 << 13,
                                            1 << 6 | 1 << 8 | 1 << 10};
    if (half_q >= clocks_per_pixel - 1) return true;
    for (int pin = 0; pin < 3; ++pin)
      if (bit_of(speed, pin) && bit_of(short_pixels[pin], h_pos_q & 15)) return true;
    return false;
  }

  bool h_last() const {
    static constexpr int last[4] = {-465, -369, -321, 319};
    return h_pos_q == last[h_region_q];
  }

  outputs comb(const inputs& in, int clocks_per_pixel) const {
    const bool en = h_en(in.speed, clocks_per_pixel);
    const bool h_step = en && h_last();
    outputs o;
    o.x2 = 2 * h_pos_q + en;
    o.y = v_pos_q;
    o.hsync_n = h_region_q != 1;
    o.vsync_n = vs_q;
    o.h_active = h_region_q == 3;
    o.active = o.h_active && v_region_q == 1;
    o.consume = o.h_active && en;
    o.line_end = o.h_active && h_step;
    o.active_start = h_region_q == 2 && h_step;
    o.nav_line = v_region_q == 3 && v_pos_q == LastLine;
    o.frame_end = o.line_end && o.nav_line;
    return o;
  }

  void clock(const inputs& in, int clocks_per_pixel) {
    static constexpr int v_last[4] = {-241, 239, 249, LastLine};
    const bool en = h_en(in.speed, clocks_per_pixel);
    const bool h_step = en && h_last();
    const bool line_end = h_step && h_region_q == 3;
    if (h_step && h_region_q == 1) vs_q = v_region_q != 3;
    if (!in.rst_n) {
      const bool vs = vs_q;
      *this = {};
      vs_q = vs;
      return;
    }
    half_q = en ? 0 : half_q + 1;
    h_pos_q = line_end ? FirstPosition : h_pos_q + en;
    h_region_q = (h_region_q + h_step) & 3;
    if (line_end) {
      const bool v_step = v_pos_q == v_last[v_region_q];
      v_pos_q = v_step && v_region_q == 3 ? FirstLine : v_pos_q + 1;
      v_region_q = (v_region_q + v_step) & 3;
    }
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, int clocks_per_pixel) const {
    visit("h_region_q", 2, [this] { return h_region_q; });
    visit("v_region_q", 2, [this] { return v_region_q; });
    visit("h_pos_q", 10, [this] { return h_pos_q; });
    visit("v_pos_q", 10, [this] { return v_pos_q; });
    visit("half_q", clocks_per_pixel > 2 ? count_bits(clocks_per_pixel) : 1,
          [this] { return half_q; });
    visit("vs_q", 1, [this] { return vs_q; });
  }
};

/// Pins of vga_timing.
class vga_timing_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Pins of the chip
  in_port<3> speed_i{"speed_i"};  // shorten pixels
  out_port<1> hsync_no{"hsync_no"};
  out_port<1> vsync_no{"vsync_no"};
  // Beam position
  out_port<11> x2_o{"x2_o"};             // signed, half pixels, -960..639
  out_port<10> y_o{"y_o"};               // signed, scan line, -273..251
  out_port<1> active_o{"active_o"};      // visible pixel
  out_port<1> h_active_o{"h_active_o"};  // visible column
  // Events, 1 for one clock
  out_port<1> consume_o{"consume_o"};            // last clock of a visible column
  out_port<1> line_end_o{"line_end_o"};          // last clock of a line
  out_port<1> active_start_o{"active_start_o"};  // last clock before the visible columns
  out_port<1> frame_end_o{"frame_end_o"};        // last clock of a frame
  // The navigator's line
  out_port<1> nav_line_o{"nav_line_o"};

  explicit vga_timing_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of vga_timing: its core behind the pins.
class vga_timing : public vga_timing_pins, public probed {
 public:
  using pins = vga_timing_pins;
  static constexpr const char* unit_name = "vga_timing";

  vga_timing(const sc_core::sc_module_name& name, int clocks_per_pixel);
  std::vector<probe> probes() const override { return registers_of(core_, clocks_per_pixel_); }

 private:
  void seq();
  void comb();

  const int clocks_per_pixel_;
  vga_timing_core core_;
};

}  // namespace racebeam
