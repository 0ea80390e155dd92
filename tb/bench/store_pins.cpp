// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/store_pins.h"

#include <zlib.h>

#include "sc/store/frame_scanout.h"

namespace racebeam {

std::uint32_t store_pins_crc(const std::vector<std::uint64_t>& words, const store_knobs& store,
                             int clocks_per_pixel) {
  const Raster raster(clocks_per_pixel);
  std::uint32_t crc = 0;
  VgaMonitor monitor(
      raster, [&](const VgaFrame& frame) { crc = frame.pins_crc; }, {false, true}, nullptr,
      StorePinout);
  std::uint64_t now = 0;
  for (int y = raster.first_line; y <= raster.last_line(); ++y) {
    const bool above = raster.vsync(y == raster.first_line ? raster.last_line() : y - 1);
    for (int clock = 0; clock < raster.line_clocks(); ++clock) {
      const int column = (clock - raster.active_begin) / clocks_per_pixel;
      frame_scanout_core::colour colour{};
      if (clock >= raster.active_begin && raster.visible_line(y) &&
          (column < store.picture_width || store.wrap_right))
        colour = frame_scanout_core::pixel(words, y - raster.first_visible_line, column, store);
      const bool vsync = clock < raster.vsync_at ? above : raster.vsync(y);
      monitor.change(now++,
                     store_pins(colour.red, colour.green, colour.blue,
                                raster.clocks[static_cast<std::size_t>(clock)].hsync, vsync));
    }
  }
  monitor.advance(now);
  return crc;
}

std::uint32_t image_crc(const PackedPicture& picture) {
  return static_cast<std::uint32_t>(
      crc32(0, picture.colours.data(), static_cast<uInt>(picture.colours.size())));
}

}  // namespace racebeam
