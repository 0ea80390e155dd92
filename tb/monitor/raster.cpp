// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/raster.h"

#include <algorithm>
#include <stdexcept>

namespace racebeam {
namespace {

constexpr int FrontPorch = 16, Sync = 96, BackPorch = 48;  // pixels
static_assert(FrontPorch + Sync + BackPorch + VisibleColumns == LinePixels);

/// Does a speed pin shorten the pixel to one clock? `low` is the low four bits of its position.
bool is_short(int low, int speed) {
  const bool pin0 = low == 7 || low == 15;
  const bool pin1 = low == 5 || low == 9 || low == 11 || low == 13;
  const bool pin2 = low == 6 || low == 8 || low == 10;
  return (pin0 && (speed & 1)) || (pin1 && (speed & 2)) || (pin2 && (speed & 4));
}

}  // namespace

Raster::Raster(int clocks_per_pixel, int speed) {
  if (clocks_per_pixel < 1 || clocks_per_pixel > 8)
    throw std::invalid_argument("raster: clocks per pixel must be 1..8");
  if (speed < 0 || speed > 7) throw std::invalid_argument("raster: speed pins must be 0..7");
  int columns = 0;
  for (int pixel = 0; pixel < LinePixels; ++pixel) {
    const int position = FirstPosition + pixel;
    const bool in_sync = pixel >= FrontPorch && pixel < FrontPorch + Sync;
    const bool visible = pixel >= FrontPorch + Sync + BackPorch;
    if (pixel == FrontPorch) sync_begin = line_clocks();
    if (pixel == FrontPorch + Sync) sync_end = line_clocks();
    if (pixel == FrontPorch + Sync + BackPorch) active_begin = line_clocks();
    const int length = is_short(position & 15, speed) ? 1 : clocks_per_pixel;
    for (int clock = 0; clock < length; ++clock) {
      clocks.push_back({static_cast<std::int16_t>(position), clock == length - 1, !in_sync});
      column_at.push_back(columns);
    }
    columns += visible;
  }
  column_at.push_back(columns);
  vsync_at = sync_end;
}

Raster::Raster(const RasterShape& shape)
    : sync_begin(shape.sync_begin),
      sync_end(shape.sync_end),
      active_begin(shape.active_begin),
      lines(shape.above + shape.rows + shape.below + shape.vsync_lines),
      first_line(-shape.rows / 2 - shape.above),
      first_visible_line(-shape.rows / 2),
      columns(shape.columns),
      rows(shape.rows),
      vsync_at(shape.sync_end),
      vsync_line(first_visible_line + shape.rows + shape.below),
      vsync_lines(shape.vsync_lines) {
  const std::int64_t width = shape.line_clocks - shape.active_begin;
  const auto pixels_before = [&](int clock) {  // since active_begin
    const std::int64_t scaled = (clock - active_begin) * std::int64_t(columns);
    return static_cast<int>(scaled >= 0 ? scaled / width : -((-scaled + width - 1) / width));
  };
  for (int clock = 0; clock < shape.line_clocks; ++clock) {
    const int pixel = pixels_before(clock);
    clocks.push_back({static_cast<std::int16_t>(pixel - columns / 2),
                      pixels_before(clock + 1) != pixel, clock < sync_begin || clock >= sync_end});
    column_at.push_back(std::max(pixel, 0));
  }
  column_at.push_back(columns);
}

void Raster::advance_syncs(int count) {
  sync_begin -= count;
  sync_end -= count;
  vsync_at -= count;
  if (vsync_at < 0) --vsync_line;
  if (vsync_at >= line_clocks()) ++vsync_line;
  vsync_at = (vsync_at + line_clocks()) % line_clocks();
}

}  // namespace racebeam
