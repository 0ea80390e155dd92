// The raster of one line and one frame as a monitor expects it, for any pixel rate and video mode.
//
// That of our chip is computed from the numbers of the video mode alone and shares no code with
// vga_timing, so that a monitor built on it checks vga_timing. What the mode leaves open is as in
// the contract until it is changed: polarity of the syncs, and where in its lines vsync changes.
// Source: contract sections 5.1, 5.2, 5.6 and 6.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/constants.h"

namespace racebeam {

/// A video mode in clocks of the chip. A line is front porch, sync pulse, back porch, visible
/// columns; a frame is the lines above the picture, the picture, those below it, the vsync pulse.
struct RasterShape {
  int line_clocks;
  int sync_begin, sync_end;  ///< of the hsync pulse
  int active_begin;          ///< the visible columns last to the end of the line
  int columns;               ///< pixels; they need not be whole clocks
  int above, rows, below, vsync_lines;
};

/// One clock of a line.
struct RasterClock {
  std::int16_t position;  ///< pixel; the visible columns of the chip's mode are -320..319
  bool last;              ///< last clock of that pixel: the one in which a monitor samples it
  bool hsync;             ///< level of the contract's hsync pin, 0 in the pulse
};

/// Every line of every frame has the same clocks; clock 0 is the first of the front porch.
struct Raster {
  /// `clocks_per_pixel` 1..8, `speed` the three speed pins 0..7. Throws std::invalid_argument.
  explicit Raster(int clocks_per_pixel = 2, int speed = 0);
  /// Another mode. vsync changes where hsync's pulse ends.
  explicit Raster(const RasterShape& shape);

  std::vector<RasterClock> clocks;  ///< one line
  int sync_begin = 0;               ///< first clock of the hsync pulse
  int sync_end = 0;                 ///< first clock after it
  int active_begin = 0;             ///< first clock of the visible columns
  std::vector<int> column_at;       ///< per clock, and one past: visible columns sampled before it

  int lines = FrameLines;
  int first_line = FirstLine;  ///< y of the first line; half of the rows are below 0
  int first_visible_line = FirstVisibleLine;
  int columns = VisibleColumns, rows = VisibleRows;

  int vsync_at = 0;      ///< vsync changes in this clock of its lines: sync_end
  int vsync_line = 250;  ///< the first line of the vsync pulse
  int vsync_lines = 2;
  bool hsync_pulse = false;  ///< level of the hsync pin in its pulse
  bool vsync_pulse = false;  ///< level of the vsync pin in its pulse

  /// The syncs come `clocks` earlier, up to the front porch; the picture stays where it is.
  void advance_syncs(int clocks);

  int line_clocks() const { return static_cast<int>(clocks.size()); }
  int frame_clocks() const { return line_clocks() * lines; }
  int last_line() const { return first_line + lines - 1; }
  bool visible_line(int y) const {
    return y >= first_visible_line && y < first_visible_line + rows;
  }
  /// Level of the vsync pin of line `y` from clock vsync_at on; before it the line above's counts.
  bool vsync(int y) const {
    return ((y - vsync_line + lines) % lines < vsync_lines) == vsync_pulse;
  }
};

}  // namespace racebeam
