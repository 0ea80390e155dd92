// Counts a frame's events from the chip's wires, one settled clock at a time.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/chip_view.h"
#include "sc/beam/frame_stats.h"

namespace racebeam {

/// Whether the tracer takes a decision in this clock: neither returns, nor waits for a room change,
/// nor walks to the right end of its interval (contract 19).
bool is_decision(const chip_view& v);

class stats_collector {
 public:
  /// One clock, in order, from the first clock of a line on.
  void observe(const chip_view& v);
  /// The counters so far, to add what was counted otherwise: whole lines.
  frame_stats& stats() { return stats_; }
  /// The counters since the last call.
  frame_stats take();
  /// The counters since the last call of take().
  const frame_stats& so_far() const { return stats_; }

 private:
  void observe_tracer(const chip_view& v);

  frame_stats stats_;
  int line_clock_ = 0;
  bool visible_ = false;
  int camera_clock_ = -1, first_emit_ = -1, done_clock_ = -1, busy_ = 0;
};

}  // namespace racebeam
