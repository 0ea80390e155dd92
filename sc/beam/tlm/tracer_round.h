// tracer_round: what the tracer does over and over after line_done.
//
// The last interval of the line is accepted, but nothing stops the tracer: it restarts at the top
// of the tree with i1 = 640 until the line ends (contract 9.8). Only the stacks keep something of
// it (contract 18, item S).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "sc/beam/decision_datapath_core.h"
#include "sc/beam/ray_stepper.h"
#include "sc/beam/stacks.h"
#include "sc/beam/subdivider_core.h"

namespace racebeam {

/// The tracer's registers when a round after line_done begins. It has no input but the starving of
/// the FIFO, so a round that ends where it began repeats until that changes.
struct tracer_round {
  subdivider_core subdivider;
  decision_datapath_core decision_datapath;
  ray_stepper_core ray_stepper;
  stacks_core stacks;
  int clock = -1;

  bool operator==(const tracer_round& other) const {
    return subdivider == other.subdivider && decision_datapath == other.decision_datapath &&
           ray_stepper == other.ray_stepper && stacks == other.stacks;
  }
};

/// Clocks of whole rounds that may be left out, where a round begins; keeps it for the next time.
[[gnu::noinline]] inline int repeated_clocks(tracer_round& last, const tracer_round& now,
                                             int starves_from, int end) {
  const bool same_input = last.clock >= starves_from || now.clock <= starves_from;
  int left_out = 0;
  if (last.clock >= 0 && same_input && now == last) {
    const int horizon = now.clock < starves_from ? std::min(starves_from, end) : end;
    const int period = now.clock - last.clock;
    left_out = (horizon - now.clock) / period * period;
  }
  last = now;
  last.clock += left_out;
  return left_out;
}

}  // namespace racebeam
