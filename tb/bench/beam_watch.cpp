// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/beam_watch.h"

#include <utility>

namespace racebeam {

// In the first clock of a frame the frame counter may still restart.
void BeamWatch::clock(int uo, const chip_view& view, int room, int face) {
  FrameWatch::clock(uo, seen() == 1 ? view.frame : frame());
  now_ = view;
  collector_.observe(view);
  watcher_.observe(view, room, face);
}

void BeamWatch::whole_frame(std::vector<std::uint8_t> colours, std::vector<IntervalEvent> intervals,
                            frame_stats stats, const chip_view& last) {
  show(std::move(colours), last.frame);
  now_ = last;
  collector_.stats() = std::move(stats);
  watcher_.put(std::move(intervals));
}

void BeamWatch::forget() {
  FrameWatch::forget();
  collector_ = {};
  watcher_ = {};
}

}  // namespace racebeam
