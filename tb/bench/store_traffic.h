// What becomes of the words of a picture between a tracer and its frame store: a plain loop over
// the cores of write_buffer and store_arbiter.
//
// The tracer needs some clocks for a pixel and offers its word in the last of them; it stays in
// that clock until the word is taken. The beam shows a pixel a clock; clock 0 is the first visible
// one of a frame. hsync is low in pixels 656..751 of a line, vsync in lines 490 and 491: the mode's
// numbers, in which vsync changes with the visible line. (Behind vga_timing it changes with the end
// of hsync, 48 pixels earlier, so that the figures there differ a little.)
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "sc/store/store_knobs.h"

namespace racebeam {

struct StoreTraffic {
  std::uint64_t words = 0, lost = 0;
  std::uint64_t clocks = 0;  ///< that the tracer needs
  std::uint64_t waited = 0;  ///< clocks more, as the buffer was full

  double waited_percent() const { return 100.0 * static_cast<double>(waited) / clocks; }
  double lost_percent() const { return 100.0 * static_cast<double>(lost) / words; }
};

/// A picture of `pixels`, of which the nth needs `clocks_of(n)` clocks, at least 1.
StoreTraffic store_traffic(int pixels, const std::function<int(int)>& clocks_of,
                           const store_knobs& k);

}  // namespace racebeam
