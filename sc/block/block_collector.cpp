// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_collector.h"

#include <algorithm>

namespace racebeam {

void block_collector::count_event(int event) {
  switch (event) {
    case BlockKept0:
    case BlockKept1:
    case BlockKept2:
    case BlockKept3: ++now_.kept_by_corner[static_cast<std::size_t>(event - BlockKept0)]; break;
    case BlockSmallVector: ++now_.small_vectors; break;
    case BlockRootOver: ++now_.root_out_of_range; break;
    default: break;
  }
}

void block_collector::count_state(core& c, int state) {
  const bool entered = state != c.state;
  now_.groups_skipped += c.met && state != BlockNear && state != BlockShadowNear;
  c.met = false;
  if (c.state == BlockShade && entered) ++c.pass;
  switch (state) {
    case BlockJob: now_.blocks += entered; break;
    case BlockClear: now_.cleared += entered; break;
    case BlockPixel: c.pass = 0; break;
    case BlockGroup:
    case BlockShadowGroup:
      c.met = c.pass == 0 || c.second;
      c.second = !c.met;
      now_.groups += c.met;
      break;
    case BlockNear:
    case BlockShadowNear:
      c.near = entered ? 1 : c.near + 1;
      now_.roots += c.near % root_clocks_ == 0;
      break;
    case BlockShade:
      now_.shades[static_cast<std::size_t>(std::min(c.pass, BlockMaxPasses - 1))] += entered;
      break;
    default: break;
  }
  c.state = state;
}

void block_collector::count_core(core& c, const block_core_view& v, std::uint64_t& busy) {
  if (v.event != BlockNoEvent) count_event(v.event);
  if (v.waits) {
    ++now_.bus_stalls;
  } else if (v.state != BlockIdle) {
    ++now_.busy_clocks;
    ++busy;
  }
  count_state(c, v.state);
}

void block_collector::observe(const block_view& v) {
  if (!v.done) {
    ++now_.clocks;
    now_.frames += frame_begins_;
    count(v.store, store_knobs_, now_);
    for (std::size_t n = 0; n < cores_of_chip_; ++n)
      count_core(cores_[n], v.cores[n], now_.busy_by_core[n]);
  } else {
    now_.host_clocks += v.sends;
  }
  frame_begins_ = v.store.frame_end;
  const bool over = draws_ && v.done;
  draws_ = !v.done;
  if (!over) return;
  for (core& c : cores_) c = {};
  last_ = now_;
  now_ = {};
  ++pictures_;
}

}  // namespace racebeam
