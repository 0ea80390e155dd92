// line_raster: vga_timing over one line, clock by clock, as a table.
//
// Every line has the same clocks (contract 5.1, 6); the table is what vga_timing_core does from the
// first clock of a line to its last.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/knobs.h"
#include "sc/beam/pwm_sound.h"
#include "sc/video/vga_timing.h"

namespace racebeam {

struct line_raster {
  explicit line_raster(const knobs& k) {
    vga_timing_core timing;
    for (bool last = false; !last;) {
      const auto out = timing.comb({true, k.speed}, k.clocks_per_pixel);
      const int clock = static_cast<int>(clocks.size());
      clocks.push_back(timing);
      x2.push_back(out.x2);
      columns_before.push_back(static_cast<int>(column_clock.size()));
      if (out.consume) column_clock.push_back(clock);
      if (out.active_start) active_begin = clock + 1;
      if (!out.hsync_n) vsync_clock = clock + 1;
      if (pwm_sound_core::is_busy(out.x2)) sound_clocks.push_back(clock);
      last = out.line_end;
      timing.clock({true, k.speed}, k.clocks_per_pixel);
    }
    columns_before.push_back(static_cast<int>(column_clock.size()));
  }

  int size() const { return static_cast<int>(clocks.size()); }

  /// vga_timing in a clock of the line of `begin`, its first clock.
  vga_timing_core at(int clock, const vga_timing_core& begin) const {
    vga_timing_core timing = begin;
    timing.h_region_q = clocks[clock].h_region_q;
    timing.h_pos_q = clocks[clock].h_pos_q;
    timing.half_q = clocks[clock].half_q;
    if (clock >= vsync_clock) timing.vs_q = begin.v_region_q != 3;
    return timing;
  }

  std::vector<vga_timing_core> clocks;  ///< horizontal registers
  std::vector<int> x2;                  ///< half-pixel position
  std::vector<int> column_clock;        ///< clock in which a visible column is consumed
  std::vector<int> columns_before;  ///< per clock, and one past: visible columns consumed before
  std::vector<int> sound_clocks;    ///< those in which pwm_sound does more than count
  int active_begin = 0;             ///< first clock of the visible columns
  int vsync_clock = 0;              ///< first clock in which vsync has this line's level
};

}  // namespace racebeam
