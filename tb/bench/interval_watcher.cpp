// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/interval_watcher.h"

#include <utility>

#include "sc/base/constants.h"
#include "sc/beam/stats_collector.h"
#include "sc/beam/subdivider.h"

namespace racebeam {

void IntervalWatcher::observe(const chip_view& v, int room, int face) {
  if (clock_ == 0) visible_ = v.y >= FirstVisibleLine && v.y < FirstVisibleLine + VisibleRows;
  if (visible_ && v.run && !v.line_done && !v.line_end) {
    decisions_ += is_decision(v);
    if (v.emit && v.state != StateReturn) {  // it is forgotten while the offer waits
      wall_ = v.wall;
      behind_ = (v.tag & low_bits(LevelBits)) != 7 || v.second;
    }
    if (v.emit && v.ack) {
      const int depth = v.tag >> LevelBits & ((1 << DepthBits) - 1);
      events_.push_back({v.y, next_, v.i2, clock_, decisions_, depth, room, face, behind_, wall_});
      next_ = v.i2 + 1;
      decisions_ = 0;
    }
  }
  ++clock_;
  if (!v.line_end) return;
  if (visible_ && next_ <= LastPixel)
    events_.push_back(
        {v.y, next_, LastPixel, IntervalEvent::Never, decisions_, 0, 0, 0, false, false});
  clock_ = next_ = decisions_ = 0;
}

std::vector<IntervalEvent> IntervalWatcher::take() { return std::exchange(events_, {}); }

}  // namespace racebeam
