// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/interval_log.h"

#include <utility>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

bool is_visible(int y) { return y >= FirstVisibleLine && y < FirstVisibleLine + VisibleRows; }

}  // namespace

void IntervalLog::interval(const taken_interval& taken) {
  if (!is_visible(taken.y)) return;
  events_.push_back({taken.y, next_, taken.last, taken.clock, taken.decisions - decisions_,
                     taken.depth, taken.room, taken.face, taken.behind, !taken.given_up});
  next_ = taken.last + 1;
  decisions_ = taken.decisions;
}

void IntervalLog::line_end(int y, int decisions) {
  if (is_visible(y) && next_ <= LastPixel)
    events_.push_back(
        {y, next_, LastPixel, IntervalEvent::Never, decisions - decisions_, 0, 0, 0, false, false});
  next_ = decisions_ = 0;
}

std::vector<IntervalEvent> IntervalLog::take() { return std::exchange(events_, {}); }

}  // namespace racebeam
