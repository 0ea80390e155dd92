// The cores of the frame store's units and of vga_timing in a plain loop, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/store/frame_memory.h"
#include "sc/store/frame_scanout.h"
#include "sc/store/store_arbiter.h"
#include "sc/store/write_buffer.h"
#include "sc/video/vga_timing.h"

namespace racebeam {

/// What a clock looks like from outside, and between the units.
struct StoreClock {
  bool put_ready, take_valid, take_ready, mem_write;
  int fill, mem_address, red, green, blue;
  bool hsync_n, vsync_n;

  std::vector<int> all() const {
    return {put_ready, take_valid, take_ready, mem_write, fill,   mem_address,
            red,       green,      blue,       hsync_n,   vsync_n};
  }
};

/// The cores in a plain loop.
class FrameStoreLoop {
 public:
  FrameStoreLoop(const store_knobs& k, int clocks_per_pixel)
      : k_(k), clocks_per_pixel_(clocks_per_pixel), memory_(k) {}

  /// One clock, with a word on offer or none.
  StoreClock clock(bool rst_n, bool put, const write_buffer_core::entry& word) {
    const auto beam = vga_.comb({rst_n, 0}, clocks_per_pixel_);
    const auto read = scanout_.reads(beam.active, beam.y, k_);
    const bool ready = store_arbiter_core::take_ready(read.valid, !beam.hsync_n || !beam.vsync_n,
                                                      !beam.active, k_);
    const auto take = buffer_.take();
    const auto colour = scanout_.shows(memory_.data_q, k_);
    const bool write = ready && buffer_.take_valid();
    const StoreClock now{buffer_.put_ready(ready, k_),
                         buffer_.take_valid(),
                         ready,
                         write,
                         buffer_.fill(k_),
                         write ? take.address : read.address,
                         colour.red,
                         colour.green,
                         colour.blue,
                         scanout_.at_pins(k_).hsync_n,
                         scanout_.at_pins(k_).vsync_n};
    scanout_.clock({rst_n, beam.consume, beam.active, beam.line_end, beam.y, beam.hsync_n,
                    beam.vsync_n, memory_.data_q},
                   k_);
    memory_.clock({write, now.mem_address, take.data}, k_);
    buffer_.clock({rst_n, put, word, ready}, k_);
    vga_.clock({rst_n, 0}, clocks_per_pixel_);
    read_ = read.valid;
    return now;
  }
  /// Whether the beam read in the clock before.
  bool read() const { return read_; }
  const std::vector<std::uint64_t>& memory() const { return memory_.words_q; }

 private:
  const store_knobs k_;
  const int clocks_per_pixel_;
  vga_timing_core vga_;
  write_buffer_core buffer_;
  frame_memory_core memory_;
  frame_scanout_core scanout_;
  bool read_ = false;
};

}  // namespace racebeam
