// frame_store: the words of a picture on their way into the frame store, for the tlm level.
//
// A closed form of vga_timing, frame_scanout's reads and store_arbiter around write_buffer_core:
// when the buffer may write follows from the clock alone. The raster is vga_timing's; clock 0 is
// the first one after its reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sc/store/store_counters.h"
#include "sc/store/write_buffer.h"

namespace racebeam {

class frame_store {
 public:
  /// `clocks_per_pixel`: of the raster.
  frame_store(const store_knobs& k, int clocks_per_pixel);

  /// The clock that is next.
  std::int64_t clock() const { return clock_; }
  /// Goes on to a clock: takes from the buffer what may be taken before it. `n`: what to count in,
  /// or nullptr.
  void go_to(std::int64_t clock, store_counters* n);
  /// On to the next frame in whose first clock the write buffer is empty, and the memory becomes
  /// black (back door).
  void await_frame();
  /// A word offered in this clock, which is over then; whether it went in.
  bool offer(int address, std::uint64_t word, store_counters& n);
  /// The same until it is in; the clocks waited.
  int put(int address, std::uint64_t word, store_counters& n);

  /// Clocks in which the beam reads, and frames begun, before a clock.
  std::uint64_t reads_before(std::int64_t clock) const;
  std::uint64_t frames_before(std::int64_t clock) const {
    return static_cast<std::uint64_t>((clock + frame_clocks_ - 1) / frame_clocks_);
  }
  std::int64_t frame_clocks() const { return frame_clocks_; }

  /// The memory, and what the write buffer has for it.
  const std::vector<std::uint64_t>& memory() const { return memory_; }
  const write_buffer_core& buffer() const { return buffer_; }
  /// The memory as it will be when the buffer is empty.
  std::vector<std::uint64_t> picture() const;

 private:
  void find_run();
  bool may_write();
  bool must_wait() {
    return fill_ == k_.write_buffer_depth && k_.when_full == WhenFullStall && !may_write();
  }
  void take(store_counters* n);

  const store_knobs k_;
  const int clocks_per_pixel_;
  const int shown_;  // columns of the picture that the beam shows
  const std::int64_t line_clocks_, frame_clocks_;
  write_buffer_core buffer_;
  int fill_ = 0;
  std::vector<std::uint64_t> memory_;
  std::int64_t clock_ = 0;
  bool open_ = false;         // the tracer may write from clock_ on
  std::int64_t run_end_ = 0;  // up to here
};

}  // namespace racebeam
