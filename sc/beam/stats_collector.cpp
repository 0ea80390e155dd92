// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/stats_collector.h"

#include <utility>

#include "sc/base/constants.h"
#include "sc/beam/subdivider.h"

namespace racebeam {

bool is_decision(const chip_view& v) {
  const bool returning = v.state == StateReturn || v.emit;
  return !returning && !v.second && !(v.state == StateLeft && v.idx2 != v.i2);
}

void stats_collector::observe(const chip_view& v) {
  ++stats_.clocks;
  if (line_clock_ == 0) visible_ = v.y >= FirstVisibleLine && v.y < FirstVisibleLine + VisibleRows;
  if (visible_) {
    if (v.consume && v.starving) ++stats_.starved_pixels;
    ++stats_.fifo_fill[v.fill];
    if (v.run) {
      if (camera_clock_ < 0) camera_clock_ = line_clock_;
      if (!v.line_done && !v.line_end) observe_tracer(v);
      if (v.line_done && !v.line_end && done_clock_ < 0) done_clock_ = line_clock_;
    }
  }
  ++line_clock_;
  if (!v.line_end) return;
  if (visible_) {
    stats_.camera_clocks.push_back(camera_clock_);
    stats_.first_emit.push_back(first_emit_);
    stats_.done_clock.push_back(done_clock_);
    stats_.busy_clocks.push_back(busy_);
  }
  camera_clock_ = first_emit_ = done_clock_ = -1;
  line_clock_ = busy_ = 0;
}

// A clock of the tracer before line_done.
void stats_collector::observe_tracer(const chip_view& v) {
  ++stats_.stack_depth[v.sd];
  const bool in_return = v.state == StateReturn;
  const bool stalled = v.emit && !v.ack;
  const bool returning = in_return || v.emit;
  if (!stalled) ++busy_;
  if (stalled) ++stats_.fifo_full_stalls;
  if (v.emit && v.ack) {
    ++stats_.emits;
    if (first_emit_ < 0) first_emit_ = line_clock_;
  }
  if (v.emit && !in_return && !v.wall) ++stats_.give_ups;
  if (v.emit && !in_return) ++stats_.returns;
  if (returning) ++stats_.return_clocks;
  if (v.restart && v.i2 != LastPixel) ++stats_.restarts;
  if (v.descend) ++stats_.descents;
  if (v.descend && (v.tag & 7) == 7) ++stats_.rooms_entered;
  if (v.push) ++stats_.pushes;
  if (!is_decision(v)) stats_.adjust_steps += !returning && !v.second;
  else if (v.state == StateLeft) ++stats_.left_decisions;
  else if (v.state == StateRight) ++stats_.right_decisions;
  else ++stats_.bisection_steps;
}

frame_stats stats_collector::take() { return std::exchange(stats_, frame_stats{}); }

}  // namespace racebeam
