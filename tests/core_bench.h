// The chip's cores in one loop, without SystemC: the reference for the wiring.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

#include "sc/chip_core.h"
#include "tb/raster.h"
#include "tb/stats_collector.h"

namespace racebeam {

class CoreBench {
 public:
  explicit CoreBench(const knobs& k, int first = 0)
      : knobs_(k), raster_(k.clocks_per_pixel, k.speed) {
    chip_.clock(false, k);
    chip_.deposit(first, k);
  }

  struct Frame {
    std::uint32_t pins_crc;
    FrameStats stats;
  };
  Frame render() {
    std::vector<std::uint8_t> pins(raster_.frame_clocks());
    Frame frame;
    StatsCollector collector;
    chip_view view;
    for (std::size_t c = 0; c < pins.size(); ++c) {
      const auto out = chip_.clock(true, knobs_, &view);
      pins[c] = static_cast<std::uint8_t>(out.uo);
      collector.observe(view);
    }
    frame.pins_crc = crc32(0, pins.data(), static_cast<uInt>(pins.size()));
    frame.stats = collector.take();
    return frame;
  }
  void skip() {
    for (int c = 0; c < raster_.frame_clocks(); ++c) chip_.clock(true, knobs_);
  }

 private:
  const knobs knobs_;
  const Raster raster_;
  chip_core chip_;
};

inline void expect_equal(const FrameStats& a, const FrameStats& b) {
  EXPECT_EQ(a.clocks, b.clocks);
  EXPECT_EQ(a.decisions(), b.decisions());
  EXPECT_EQ(a.adjust_steps, b.adjust_steps);
  EXPECT_EQ(a.descents, b.descents);
  EXPECT_EQ(a.pushes, b.pushes);
  EXPECT_EQ(a.return_clocks, b.return_clocks);
  EXPECT_EQ(a.emits, b.emits);
  EXPECT_EQ(a.restarts, b.restarts);
  EXPECT_EQ(a.give_ups, b.give_ups);
  EXPECT_EQ(a.starved_pixels, b.starved_pixels);
  EXPECT_EQ(a.fifo_full_stalls, b.fifo_full_stalls);
  EXPECT_EQ(a.fifo_fill, b.fifo_fill);
  EXPECT_EQ(a.stack_depth, b.stack_depth);
  EXPECT_EQ(a.done_clock, b.done_clock);
  EXPECT_EQ(a.busy_clocks, b.busy_clocks);
}

}  // namespace racebeam
