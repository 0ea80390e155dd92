// Counts a frame's events from the chip's wires, one settled clock at a time.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/base/constants.h"
#include "sc/beam/chip_view.h"
#include "sc/beam/frame_stats.h"

namespace racebeam {

/// Whether the tracer takes a decision in this clock: neither returns, nor waits for a room change,
/// nor walks to the right end of its interval (contract 19).
bool is_decision(const chip_view& v);

/// What the chip does with this clock of a line.
line_part part_of(const chip_view& v);

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
  /// What is known of a line while it is traced.
  struct line {
    std::array<int, LineParts> parts{};
    int clock = 0, camera_clock = -1, first_emit = -1, done_clock = -1, busy = 0;
    int column = 0;                           // that is shown next
    int left = 0;                             // the left end's answer, with its signs
    int walk = 0;                             // steps of dr2 so far
    int value = 0;                            // colour of the last interval
    bool given_up = false;                    // that interval
    int sd = 0, stack = 0, stack_needed = 0;  // the stack's entries; those of an endless one, most
    int taken = 1;                            // columns that the FIFO has, or had
    int since[VisibleColumns] = {-1};  // the clock in which a column became known; -1: it did not
  };
  void show(const chip_view& v);
  void observe_tracer(const chip_view& v);
  void take_in(const chip_view& v);
  void observe_stack(const chip_view& v);
  void observe_decision(const chip_view& v);

  frame_stats stats_;
  line line_;
  bool visible_ = false;
};

}  // namespace racebeam
