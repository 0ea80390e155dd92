// IntervalWatcher: finds the intervals of the visible lines in the chip's wires.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "sc/beam/chip_view.h"
#include "tb/bench/interval_event.h"

namespace racebeam {

class IntervalWatcher {
 public:
  /// One settled clock, in order, from the first clock of a line on; `room` and `face` are those of
  /// decision_datapath (room_o, hit_face_o).
  void observe(const chip_view& v, int room, int face);

  /// What another saw of whole lines, instead of observing them.
  void put(std::vector<IntervalEvent> events) { events_ = std::move(events); }

  /// What was seen since the last call. A line that ended before its last pixel was known ends with
  /// an event of clock Never, which has its rest of pixels and decisions.
  std::vector<IntervalEvent> take();
  /// What was seen since the last take().
  const std::vector<IntervalEvent>& seen() const { return events_; }

 private:
  std::vector<IntervalEvent> events_;
  int clock_ = 0;  // of the line
  bool visible_ = false;
  int next_ = 0;         // first pixel of the line that is not known
  int decisions_ = 0;    // since the last interval
  bool wall_ = false;    // the interval on offer hit one
  bool behind_ = false;  // as IntervalEvent has it
};

}  // namespace racebeam
