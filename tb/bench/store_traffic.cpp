// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/store_traffic.h"

#include "sc/base/constants.h"
#include "sc/store/store_arbiter.h"
#include "sc/store/write_buffer.h"

namespace racebeam {

namespace {

/// The pixel that the beam is at.
struct BeamPixel {
  int column = 0, line = 0;

  bool visible() const { return column < VisibleColumns && line < VisibleRows; }
  bool sync() const { return (column >= 656 && column < 752) || line == 490 || line == 491; }
  void next() {
    if (++column < LinePixels) return;
    column = 0;
    if (++line == FrameLines) line = 0;
  }
};

}  // namespace

StoreTraffic store_traffic(int pixels, const std::function<int(int)>& clocks_of,
                           const store_knobs& k) {
  StoreTraffic all;
  write_buffer_core buffer;
  BeamPixel beam;
  // Whether the word is taken, if there is one.
  const auto clock = [&](bool put, int pixel) {
    const bool take_ready =
        store_arbiter_core::take_ready(beam.visible(), beam.sync(), !beam.visible(), k);
    const write_buffer_core::inputs in{true, put, {pixel, 0}, take_ready};
    const bool taken = put && buffer.put_ready(take_ready, k);
    all.lost += static_cast<std::uint64_t>(buffer.lost(in, k));
    buffer.clock(in, k);
    beam.next();
    return taken;
  };
  for (int pixel = 0; pixel < pixels; ++pixel) {
    const int clocks = clocks_of(pixel);
    for (int n = 1; n < clocks; ++n) clock(false, pixel);
    while (!clock(true, pixel)) ++all.waited;
    all.clocks += static_cast<std::uint64_t>(clocks);
  }
  all.words = static_cast<std::uint64_t>(pixels);
  return all;
}

}  // namespace racebeam
