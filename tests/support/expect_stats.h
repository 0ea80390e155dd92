// Equality of all that is counted in a frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/beam/frame_stats.h"

namespace racebeam {

inline void expect_equal(const frame_stats& a, const frame_stats& b) {
  EXPECT_EQ(a.clocks, b.clocks);
  EXPECT_EQ(a.decisions(), b.decisions());
  EXPECT_EQ(a.adjust_steps, b.adjust_steps);
  EXPECT_EQ(a.descents, b.descents);
  EXPECT_EQ(a.pushes, b.pushes);
  EXPECT_EQ(a.return_clocks, b.return_clocks);
  EXPECT_EQ(a.emits, b.emits);
  EXPECT_EQ(a.restarts, b.restarts);
  EXPECT_EQ(a.give_ups, b.give_ups);
  EXPECT_EQ(a.starved_pixels, b.starved_pixels);
  EXPECT_EQ(a.fifo_full_stalls, b.fifo_full_stalls);
  EXPECT_EQ(a.fifo_fill, b.fifo_fill);
  EXPECT_EQ(a.stack_depth, b.stack_depth);
  EXPECT_EQ(a.done_clock, b.done_clock);
  EXPECT_EQ(a.busy_clocks, b.busy_clocks);
}

}  // namespace racebeam
