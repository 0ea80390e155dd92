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
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/beam/knobs.h"
#include "tb/base/spread.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// A clock of each line, of one or more frames.
struct LineSpread {
  Spread clocks;
  int without = 0;                                  ///< lines in which it never came
  int worst_frame = 0, worst_line = 0, worst = -1;  ///< the line with the largest

  /// -1: it never came.
  void add(int frame, const std::vector<int>& lines);
};

class StatsReport {
 public:
  /// Of a chip of `counter`, whose tables name what is counted.
  StatsReport(const engine& counter, std::string scene, std::string level, const knobs& k);

  /// Adds a whole frame; with its CRCs if `crc`, with its comparison if there is one.
  void add(int frame, const std::string& part, const frame_counts& stats, const VgaFrame& picture,
           bool crc, const std::optional<GoldenCounts>& golden = {});
  /// The whole document; one line per frame. `against`: the comparison with a reference as JSON, if
  /// there was one.
  std::string text(const std::string& against = "") const;

  int frames() const { return static_cast<int>(frames_.size()); }
  const engine& counter() const { return engine_; }
  /// The sums of all counters and histograms.
  const frame_counts& sums() const { return sums_; }
  /// The sums over all lines, by engine::lines.
  std::vector<std::uint64_t> line_sums() const;
  /// The sums of the comparisons, if there were any.
  const std::optional<GoldenCounts>& golden() const { return golden_; }

 private:
  nlohmann::ordered_json json_of_counts(const frame_counts& counts) const;
  nlohmann::ordered_json json_of_lines(const std::vector<LineSpread>& lines, bool whole_run) const;

  const engine& engine_;
  const std::string scene_, level_;
  const knobs knobs_;
  std::vector<std::string> frames_;  // JSON texts
  frame_counts sums_;
  std::vector<LineSpread> lines_;
  std::optional<GoldenCounts> golden_;
};

}  // namespace racebeam
