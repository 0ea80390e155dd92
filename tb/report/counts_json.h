// What was counted, as JSON: by the tables of an engine, or of a golden tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "sc/base/frame_counts.h"
#include "tb/base/spread.h"

namespace racebeam {

/// A clock of each line, of one or more frames.
struct LineSpread {
  Spread clocks;
  int without = 0;                                  ///< lines in which it never came
  int worst_frame = 0, worst_line = 0, worst = -1;  ///< the line with the largest

  /// -1: it never came.
  void add(int frame, const std::vector<int>& lines);
};

/// Counters by their names, then histograms by theirs: the values that can be.
nlohmann::ordered_json counts_json(const std::vector<counter_info>& counters,
                                   const std::vector<histogram_info>& histograms,
                                   const knob_values& k, const frame_counts& counts);

/// Spreads over lines by their names: {min, mean, max, sum, ...}, or null. Of several frames, if
/// `whole_run`.
nlohmann::ordered_json lines_json(const std::vector<line_info>& infos,
                                  const std::vector<LineSpread>& lines, bool whole_run);

}  // namespace racebeam
