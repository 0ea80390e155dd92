// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/beam_screen.h"

#include "tb/monitor/vga_monitor.h"

namespace racebeam {

namespace {

constexpr int Syncs = 1 << PinHsync | 1 << PinVsync;

}  // namespace

BeamScreen::BeamScreen(const Raster& raster)
    : raster_(raster),
      colours_(static_cast<std::size_t>(raster.columns) * raster.rows),
      y_(raster.first_line) {}

// The edges that begin the pulses: hsync gives the place in the line, vsync the line.
void BeamScreen::find_place(int uo, int changed) {
  const bool hsync = uo >> PinHsync & 1, vsync = uo >> PinVsync & 1;
  if ((changed >> PinHsync & 1) && hsync == raster_.hsync_pulse) clock_ = raster_.sync_begin;
  if ((changed >> PinVsync & 1) && vsync == raster_.vsync_pulse) {
    y_ = raster_.vsync_line;
    clock_ = raster_.vsync_at;
  }
}

void BeamScreen::clock(int uo) {
  const int changed = (uo ^ uo_) & Syncs;
  uo_ = uo;
  if (changed && started_) find_place(uo, changed);
  started_ = true;
  if (clock_ >= raster_.active_begin && raster_.clocks[clock_].last && raster_.visible_line(y_)) {
    const int column = raster_.column_at[clock_];
    colours_[(y_ - raster_.first_visible_line) * raster_.columns + column] =
        static_cast<std::uint8_t>(colour_of_pins(uo));
  }
  if (++clock_ < raster_.line_clocks()) return;
  clock_ = 0;
  if (++y_ > raster_.last_line()) y_ = raster_.first_line;
}

}  // namespace racebeam
