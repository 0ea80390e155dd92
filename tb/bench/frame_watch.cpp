// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/frame_watch.h"

#include <utility>

namespace racebeam {

void FrameWatch::clock(int uo, const chip_view& view, int room, int face) {
  if (whole()) forget();
  if (++seen_ == 2) frame_ = view.frame;  // in its first clock the counter may still restart
  now_ = view;
  screen_.clock(uo);
  collector_.observe(view);
  watcher_.observe(view, room, face);
}

void FrameWatch::clock(int uo, int frame) {
  if (whole()) forget();
  ++seen_;
  frame_ = frame;
  screen_.clock(uo);
}

void FrameWatch::frame(std::vector<std::uint8_t> colours, std::vector<IntervalEvent> intervals,
                       frame_stats stats, const chip_view& last) {
  seen_ = raster_.frame_clocks();
  frame_ = last.frame;
  now_ = last;
  screen_.show(std::move(colours));
  collector_.stats() = std::move(stats);
  watcher_.put(std::move(intervals));
}

void FrameWatch::restart() {
  forget();
  screen_.home();
}

void FrameWatch::forget() {
  collector_ = {};
  watcher_ = {};
  seen_ = 0;
}

}  // namespace racebeam
