// FrameWatch: all that a viewer wants to know of the frame at the beam, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/chip_view.h"
#include "sc/beam/frame_stats.h"
#include "sc/beam/stats_collector.h"
#include "tb/bench/interval_watcher.h"
#include "tb/monitor/beam_screen.h"

namespace racebeam {

class FrameWatch {
 public:
  explicit FrameWatch(const Raster& raster) : raster_(raster), screen_(raster) {}

  /// The next clock: the pins, the settled wires, room and hit face of decision_datapath.
  void clock(int uo, const chip_view& view, int room, int face);
  /// The same of a chip of which the pins alone are known: no intervals, no statistics.
  void clock(int uo, int frame);
  /// A whole frame at once, before its first clock: its colours, 640 x 480; what its clocks would
  /// have told; the wires of its last clock.
  void frame(std::vector<std::uint8_t> colours, std::vector<IntervalEvent> intervals,
             frame_stats stats, const chip_view& last);
  /// The next clock is the first of a frame, wherever the last one was; the picture stays.
  void restart();

  /// Clocks of the frame that were seen; 0..clocks of a frame. The last whole frame stays until
  /// the first clock of the next.
  int seen() const { return seen_; }
  bool whole() const { return seen_ == raster_.frame_clocks(); }
  const Raster& raster() const { return raster_; }
  const BeamScreen& screen() const { return screen_; }
  /// Of the frame so far.
  const std::vector<IntervalEvent>& intervals() const { return watcher_.seen(); }
  const frame_stats& stats() const { return collector_.so_far(); }
  /// The wires of the last clock.
  const chip_view& now() const { return now_; }
  /// Number of the frame at the beam.
  int frame() const { return frame_; }

 private:
  void forget();

  const Raster raster_;
  BeamScreen screen_;
  stats_collector collector_;
  IntervalWatcher watcher_;
  chip_view now_{};
  int seen_ = 0, frame_ = 0;
};

}  // namespace racebeam
