// The statistics of a run as JSON: stats.json, schema "racebeam-stats" version 3, which is version
// 2 with "engine".
//
// One object per frame and one for all frames together. Where a picture takes its own time they are
// "pictures", of {picture, part, clocks, frames, counters, per_pixel}: clocks from start to end,
// the frames of the raster that began meanwhile, and each counter of the engine by pixels of the
// picture. Spreads over the visible lines are objects {min, mean, max, sum, ...} in clocks, or null
// if no line has a value; lines are counted as in the contract, -240..239. Those of the parts of a
// line, line_camera to line_idle, add up to all clocks of the visible lines. "golden" is there if
// the chip was compared with the golden tracers, "against" if with a reference.
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
#include "tb/bench/chip_bench.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/report/counts_json.h"

namespace racebeam {

class StatsReport {
 public:
  /// Of a chip of `counter`, whose tables name what is counted.
  StatsReport(const engine& counter, std::string scene, std::string level, const knob_values& k);

  /// Adds a whole frame, or picture; with its CRCs if `crc`, with its comparison if there is one.
  /// `time`: of a picture that takes its own.
  void add(int frame, const std::string& part, const frame_counts& stats, const VgaFrame& picture,
           bool crc, const std::optional<GoldenCounts>& golden = {}, const PictureTime& time = {});
  /// The whole document; one line per frame. `against`: the comparison with a reference as JSON, if
  /// there was one.
  std::string text(const std::string& against = "") const;

  int frames() const { return static_cast<int>(frames_.size()); }
  /// The sum of the times of all pictures.
  const PictureTime& time() const { return time_; }
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
  /// Of one picture, or of all.
  nlohmann::ordered_json json_of(const frame_counts& counts, const PictureTime& time,
                                 std::uint64_t pixels) const;

  const engine& engine_;
  const std::string scene_, level_;
  const knob_values knobs_;
  std::vector<std::string> frames_;  // JSON texts
  frame_counts sums_;
  std::vector<LineSpread> lines_;
  std::optional<GoldenCounts> golden_;
  PictureTime time_;  // of all
  std::uint64_t pixels_ = 0;
};

}  // namespace racebeam
