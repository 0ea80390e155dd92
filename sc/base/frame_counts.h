// What an engine counts in a frame, as plain numbers in the order of its tables, and those tables.
//
// Whoever lists counters, such as stats.json, the table that `render` prints, the viewer and the
// registers of the tlm level, goes through the tables and knows no engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/knob_values.h"

namespace racebeam {

/// A number of a frame.
struct counter_info {
  const char* name;   ///< in files
  const char* title;  ///< for people, in the viewer; "": it is in files only
  int column;         ///< its width in the table of frames; 0: it is not there
};

/// How many clocks, or other things, of a frame had each value 0, 1, ...
struct histogram_info {
  const char* name;
  const char* most;  ///< the knob that is the largest value that can be; nullptr: `limit`
  int limit = 0;
  int less = 0;  ///< the largest value is so much less than the knob

  int largest(const knob_values& k) const { return most ? k.of(most) - less : limit; }
};

/// A clock of each visible line, or another number of it; -1: it never came.
struct line_info {
  const char* name;
  const char* without;  ///< what the lines in which it never came are called in files; "": all have
                        ///< it
  bool always;          ///< files have it even if no line does
  const char* title;    ///< for people, if the sum over lines says something; else ""
  /// What a part of a line's clocks is spent on, for people: all such rows of a line add up to its
  /// clocks; else "".
  const char* part = "";
};

struct frame_counts {
  std::vector<std::uint64_t> counters;
  std::vector<std::vector<std::uint64_t>> histograms;
  std::vector<std::vector<int>> lines;

  /// Adds the counters and histograms of another frame.
  void add(const frame_counts& frame) {
    counters.resize(frame.counters.size());
    histograms.resize(frame.histograms.size());
    for (std::size_t n = 0; n < frame.counters.size(); ++n) counters[n] += frame.counters[n];
    for (std::size_t n = 0; n < frame.histograms.size(); ++n) {
      histograms[n].resize(frame.histograms[n].size());
      for (std::size_t value = 0; value < histograms[n].size(); ++value)
        histograms[n][value] += frame.histograms[n][value];
    }
  }
};

}  // namespace racebeam
