// Equality of all that is counted in a frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "sc/beam/counters.h"

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

/// All parts of each line add up to its clocks.
inline void expect_whole_lines(const frame_counts& counts, int clocks) {
  for (std::size_t line = 0; line < counts.lines.at(0).size(); ++line) {
    int all = 0;
    for (std::size_t n = 0; n < line_table().size(); ++n)
      if (*line_table()[n].info.part) all += counts.lines[n].at(line);
    ASSERT_EQ(all, clocks) << "visible line " << line;
  }
}

/// What was counted so.
inline frame_stats stats_of(const frame_counts& counts) {
  frame_stats stats;
  for (std::size_t n = 0; n < counter_table().size(); ++n)
    if (const auto member = counter_table()[n].member) stats.*member = counts.counters.at(n);
  for (std::size_t n = 0; n < histogram_table().size(); ++n) {
    const auto& values = counts.histograms.at(n);
    std::copy(values.begin(), values.end(), (stats.*histogram_table()[n].member).begin());
  }
  for (std::size_t n = 0; n < line_table().size(); ++n)
    stats.*line_table()[n].member = counts.lines.at(n);
  return stats;
}

/// All of it.
inline void expect_equal(const frame_counts& got, const frame_stats& expected) {
  const frame_counts want = counted(expected);
  for (std::size_t n = 0; n < want.counters.size(); ++n)
    EXPECT_EQ(got.counters.at(n), want.counters[n]) << counter_table()[n].info.name;
  EXPECT_EQ(got.histograms, want.histograms);
  EXPECT_EQ(got.lines, want.lines);
}

}  // namespace racebeam
