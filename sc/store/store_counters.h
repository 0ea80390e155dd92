// What is counted of a frame store while a picture is drawn into it. An engine's counters contain
// these.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sc/store/store_knobs.h"

namespace racebeam {

struct store_counters {
  std::uint64_t words = 0;          ///< into the write buffer
  std::uint64_t buffer_stalls = 0;  ///< clocks in which a word waited, since it was full
  std::uint64_t buffer_lost = 0;    ///< words
  std::uint64_t store_reads = 0, store_writes = 0;
  std::array<std::uint64_t, MaxWriteBuffer + 1> buffer_fill{};  ///< clocks with so many words
};

/// The wires of a clock around the frame store, settled.
struct store_view {
  bool word_valid, word_ready, take_ready;
  int fill;
  bool read, mem_write;
  bool frame_end;
};

/// Counts a clock of a picture.
inline void count(const store_view& v, const store_knobs& k, store_counters& n) {
  ++n.buffer_fill[static_cast<std::size_t>(v.fill)];
  n.store_reads += v.read;
  n.store_writes += v.mem_write;
  if (!v.word_valid) return;
  ++(v.word_ready ? n.words : n.buffer_stalls);
  if (k.when_full == WhenFullDrop && v.fill == k.write_buffer_depth && !v.take_ready)
    n.buffer_lost += static_cast<std::uint64_t>(v.fill);
}

}  // namespace racebeam
