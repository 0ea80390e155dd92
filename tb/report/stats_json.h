// The statistics of a run as JSON: stats.json, schema "racebeam-stats" version 2.
//
// One object per frame and one for all frames together. Spreads over the visible lines are objects
// {min, mean, max, sum, ...} in clocks, or null if no line has a value; lines are counted as in the
// contract, -240..239. Those of the parts of a line, line_camera to line_idle, add up to all clocks
// of the visible lines. "golden" is there if the chip was compared with the golden tracers,
// "against" if with a reference.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/beam/knobs.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/report/counts_json.h"

namespace racebeam {

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
  /// Over all lines, by engine::lines.
  const std::vector<LineSpread>& lines() const { return lines_; }
  /// The sums of the comparisons, if there were any.
  const std::optional<GoldenCounts>& golden() const { return golden_; }

 private:
  nlohmann::ordered_json json_of(const frame_counts& counts, const std::vector<LineSpread>& lines,
                                 bool whole_run) const;

  const engine& engine_;
  const std::string scene_, level_;
  const knobs knobs_;
  std::vector<std::string> frames_;  // JSON texts
  frame_counts sums_;
  std::vector<LineSpread> lines_;
  std::optional<GoldenCounts> golden_;
};

}  // namespace racebeam
