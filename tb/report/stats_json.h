// The statistics of a run as JSON: stats.json, schema "racebeam-stats" version 1.
//
// One object per frame and one for all frames together. Spreads over the visible lines are objects
// {min, mean, max, ...} in clocks, or null if no line has a value; lines are counted as in the
// contract, -240..239. "golden" is there if the chip was compared with the golden tracers,
// "against" if with a reference.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sc/beam/frame_stats.h"
#include "sc/beam/knobs.h"
#include "tb/base/spread.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// Per-line clocks of one or more frames.
struct LineSpreads {
  Spread camera_clocks, first_emit, done_clock, busy_clocks;
  int lines_without_emit = 0, lines_not_done = 0;
  int worst_frame = 0, worst_line = 0, worst_busy = -1;  ///< the line with most busy clocks

  void add(int frame, const frame_stats& stats);
};

class StatsReport {
 public:
  StatsReport(std::string scene, std::string level, const knobs& k);

  /// Adds a whole frame; with its CRCs if `crc`, with its comparison if there is one.
  void add(int frame, const std::string& part, const frame_stats& stats, const VgaFrame& picture,
           bool crc, const std::optional<GoldenCounts>& golden = {});
  /// The whole document; one line per frame. `against`: the comparison with a reference as JSON, if
  /// there was one.
  std::string text(const std::string& against = "") const;

  int frames() const { return static_cast<int>(frames_.size()); }
  /// The sums of all counters; without what is kept per line.
  const frame_stats& sums() const { return sums_; }
  /// The sums of the comparisons, if there were any.
  const std::optional<GoldenCounts>& golden() const { return golden_; }
  std::uint64_t busy_clocks() const { return lines_.busy_clocks.sum(); }

 private:
  const std::string scene_, level_;
  const knobs knobs_;
  std::vector<std::string> frames_;  // JSON texts
  frame_stats sums_;
  LineSpreads lines_;
  std::optional<GoldenCounts> golden_;
};

}  // namespace racebeam
