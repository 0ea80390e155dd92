// BeamWatch: what a viewer wants to know of a frame of the interval tracer, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/chip_view.h"
#include "sc/beam/frame_stats.h"
#include "sc/beam/stats_collector.h"
#include "tb/bench/frame_watch.h"
#include "tb/bench/interval_watcher.h"

namespace racebeam {

class BeamWatch final : public FrameWatch {
 public:
  using FrameWatch::FrameWatch;

  /// The next clock: the pins, the settled wires, room and hit face of decision_datapath.
  void clock(int uo, const chip_view& view, int room, int face);
  /// A whole frame at once, before its first clock: its colours, 640 x 480; what its clocks would
  /// have told; the wires of its last clock.
  void whole_frame(std::vector<std::uint8_t> colours, std::vector<IntervalEvent> intervals,
                   frame_stats stats, const chip_view& last);

  /// Of the frame so far.
  const std::vector<IntervalEvent>& intervals() const { return watcher_.seen(); }
  const frame_stats& stats() const { return collector_.so_far(); }
  /// The wires of the last clock.
  const chip_view& now() const { return now_; }

 private:
  void forget() override;

  stats_collector collector_;
  IntervalWatcher watcher_;
  chip_view now_{};
};

}  // namespace racebeam
