// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/stats_collector.h"

#include <algorithm>
#include <utility>

#include "sc/base/constants.h"
#include "sc/beam/subdivider.h"

namespace racebeam {

bool is_decision(const chip_view& v) {
  const bool returning = v.state == StateReturn || v.emit;
  return !returning && !v.second && !(v.state == StateLeft && v.idx2 != v.i2);
}

line_part part_of(const chip_view& v) {
  if (v.line_end || (v.run && v.line_done)) return PartIdle;
  if (!v.run) return PartCamera;
  if (v.emit && !v.ack) return PartWait;
  if (v.emit || v.state == StateReturn) return PartReturn;
  if (v.second) return PartEnter;
  if (!is_decision(v)) return PartWalk;
  return v.state == StateBisect ? PartBisect : PartDecide;
}

void stats_collector::observe(const chip_view& v) {
  ++stats_.clocks;
  if (line_.clock == 0) visible_ = v.y >= FirstVisibleLine && v.y < FirstVisibleLine + VisibleRows;
  if (visible_) {
    if (v.consume) show(v);
    ++stats_.fifo_fill[v.fill];
    ++line_.parts[part_of(v)];
    if (v.run) {
      if (line_.camera_clock < 0) line_.camera_clock = line_.clock;
      if (!v.line_done && !v.line_end) observe_tracer(v);
      if (v.line_done && !v.line_end && line_.done_clock < 0) line_.done_clock = line_.clock;
    }
  }
  ++line_.clock;
  if (!v.line_end) return;
  if (visible_) {
    stats_.camera_clocks.push_back(line_.camera_clock);
    stats_.first_emit.push_back(line_.first_emit);
    stats_.done_clock.push_back(line_.done_clock);
    stats_.busy_clocks.push_back(line_.busy);
    stats_.stack_needed.push_back(line_.stack_needed);
    stats_.add_line(line_.parts);
  }
  line_ = {};
}

// The last clock of a column.
void stats_collector::show(const chip_view& v) {
  if (v.starving || !v.run) {
    ++stats_.starved_pixels;
    stats_.seen_starved_pixels += !v.lock;
  } else if (line_.column < line_.taken && line_.since[line_.column] >= 0) {
    ++bin_of(stats_.slack, (line_.clock - line_.since[line_.column]) / SlackBin);
  }
  ++line_.column;
}

// A clock of the tracer before line_done.
void stats_collector::observe_tracer(const chip_view& v) {
  const bool in_return = v.state == StateReturn;
  const bool stalled = v.emit && !v.ack;
  const bool returning = in_return || v.emit;
  if (!stalled) ++line_.busy;
  if (stalled) ++stats_.fifo_full_stalls;
  if (v.emit && !in_return) {
    line_.given_up = !v.wall;
    ++stats_.returns;
    stats_.give_ups += line_.given_up;
  }
  if (v.emit && v.ack) take_in(v);
  if (returning) ++stats_.return_clocks;
  if (v.restart && v.i2 != LastPixel) ++stats_.restarts;
  if (v.descend) ++stats_.descents;
  if (v.descend && (v.tag & 7) == 7) ++stats_.rooms_entered;
  observe_stack(v);
  observe_decision(v);
}

// An interval goes into the FIFO: pixel i2 is shown in column i2 + 1.
void stats_collector::take_in(const chip_view& v) {
  ++stats_.emits;
  stats_.merges += v.value == line_.value;
  line_.value = v.value;
  while (line_.taken <= v.i2 + 1 && line_.taken < VisibleColumns)
    line_.since[line_.taken++] = line_.given_up ? -1 : line_.clock;
  if (line_.first_emit < 0) line_.first_emit = line_.clock;
}

// An entry is gone when the depth falls; a restart drops all that should be there.
void stats_collector::observe_stack(const chip_view& v) {
  ++stats_.stack_depth[v.sd];
  if (v.sd < line_.sd) --line_.stack;
  line_.sd = v.sd;
  if (v.push) {
    ++stats_.pushes;
    ++line_.stack;
  }
  if (v.restart) line_.stack = 0;
  line_.stack_needed = std::max(line_.stack_needed, line_.stack);
}

void stats_collector::observe_decision(const chip_view& v) {
  const bool returning = v.state == StateReturn || v.emit;
  if (returning) line_.walk = 0;
  else if (v.state == StateLeft && v.idx2 != v.i2) ++line_.walk;
  if (v.state == StateLeft && !returning && !v.second)
    line_.left = (line_.left & ~v.mask) | (v.dec & v.mask);
  if (!is_decision(v)) {
    stats_.adjust_steps += !returning && !v.second;
  } else if (v.state == StateLeft) {
    ++stats_.left_decisions;
    ++bin_of(stats_.walk_steps, line_.walk);
    line_.walk = 0;
  } else if (v.state == StateRight) {
    ++stats_.right_decisions;
    stats_.sign_splits += ((line_.left ^ v.dec) & v.mask & ~1) != 0;
  } else {
    ++stats_.bisection_steps;
  }
}

frame_stats stats_collector::take() { return std::exchange(stats_, frame_stats{}); }

}  // namespace racebeam
