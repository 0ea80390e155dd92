// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_pins.h"

#include "sc/store/frame_scanout.h"

namespace racebeam {

std::uint32_t sphere_pins_crc(const std::vector<std::uint64_t>& words, const sphere_knobs& k) {
  const Raster raster(k.clocks_per_pixel);
  const store_knobs store = k.store();
  std::uint32_t crc = 0;
  VgaMonitor monitor(
      raster, [&](const VgaFrame& frame) { crc = frame.pins_crc; }, {false, true}, nullptr,
      SpherePinout);
  std::uint64_t now = 0;
  for (int y = raster.first_line; y <= raster.last_line(); ++y) {
    const bool above = raster.vsync(y == raster.first_line ? raster.last_line() : y - 1);
    for (int clock = 0; clock < raster.line_clocks(); ++clock) {
      const int column = (clock - raster.active_begin) / k.clocks_per_pixel;
      frame_scanout_core::colour colour{};
      if (clock >= raster.active_begin && raster.visible_line(y) &&
          (column < store.picture_width || store.wrap_right))
        colour =
            frame_scanout_core::unpack(words[static_cast<std::size_t>(frame_scanout_core::address(
                                           y - raster.first_visible_line, column, 0, store))],
                                       store);
      const bool vsync = clock < raster.vsync_at ? above : raster.vsync(y);
      monitor.change(now++,
                     sphere_pins(colour.red, colour.green, colour.blue,
                                 raster.clocks[static_cast<std::size_t>(clock)].hsync, vsync));
    }
  }
  monitor.advance(now);
  return crc;
}

}  // namespace racebeam
