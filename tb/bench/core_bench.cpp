// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/core_bench.h"

#include <zlib.h>

#include "sc/beam/stats_collector.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

CoreBench::CoreBench(const knobs& k, int first, const scene_program* program)
    : knobs_(k), raster_(k.clocks_per_pixel, k.speed), chip_(program) {
  chip_.clock(false, k);
  chip_.deposit(first, k);
}

// Calls see(pins, whether a monitor samples a visible pixel) in each clock.
template <class See>
void CoreBench::run(int lines, chip_view* view, const See& see) {
  for (int y = FirstLine; y < FirstLine + lines; ++y)
    for (int clock = 0; clock < raster_.line_clocks(); ++clock) {
      const int pins = chip_.clock(true, knobs_, view).uo;
      see(pins,
          raster_.visible_line(y) && clock >= raster_.active_begin && raster_.clocks[clock].last);
    }
}

CoreBench::Frame CoreBench::render() {
  std::vector<std::uint8_t> all_pins;
  all_pins.reserve(raster_.frame_clocks());
  Frame frame;
  frame.colours.reserve(VisibleColumns * VisibleRows);
  stats_collector collector;
  chip_view view;
  run(FrameLines, &view, [&](int pins, bool visible) {
    all_pins.push_back(static_cast<std::uint8_t>(pins));
    if (visible) frame.colours.push_back(static_cast<std::uint8_t>(colour_of_pins(pins)));
    collector.observe(view);
  });
  frame.pins_crc =
      static_cast<std::uint32_t>(crc32(0, all_pins.data(), static_cast<uInt>(all_pins.size())));
  frame.stats = collector.take();
  return frame;
}

std::vector<std::uint8_t> CoreBench::picture() {
  std::vector<std::uint8_t> colours;
  colours.reserve(VisibleColumns * VisibleRows);
  run(FirstVisibleLine + VisibleRows - FirstLine, nullptr, [&](int pins, bool visible) {
    if (visible) colours.push_back(static_cast<std::uint8_t>(colour_of_pins(pins)));
  });
  return colours;
}

void CoreBench::skip() {
  run(FrameLines, nullptr, [](int, bool) {});
}

}  // namespace racebeam
