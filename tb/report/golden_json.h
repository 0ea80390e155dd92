// Golden tracers in JSON: a comparison in stats.json, and the statistics of a render without a
// chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sc/beam/knobs.h"
#include "tb/golden/golden_work.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/report/counts_json.h"

namespace racebeam {

/// {"differing_pixels": {"trace2": N, ...}, "causes": {"give_up": N, ...}}; of PictureErrors
/// {"pixels", "differing_pixels", "by_more_than_one_level", "wrong_first_hits", "levels", "rmse",
/// "psnr"}.
nlohmann::ordered_json golden_json(const GoldenCounts& counts);

/// stats.json of a render by a golden tracer, schema "racebeam-golden" version 2: frames with their
/// checksums and what the tracer counts, by its tables. There is no chip, so there are none of
/// its counters.
class GoldenFrames {
 public:
  GoldenFrames(std::string scene, GoldenTracer tracer, GoldenTables tables, const knob_values& k);

  /// Adds a whole frame; with the CRC of its picture if `crc`.
  void add(int frame, const std::string& part, const frame_counts& counts, const VgaFrame& picture,
           bool crc);
  /// The whole document; one line per frame.
  std::string text() const;
  int frames() const { return static_cast<int>(frames_.size()); }
  GoldenTracer tracer() const { return tracer_; }
  const GoldenTables& tables() const { return tables_; }
  /// Of all frames, by tables().
  const frame_counts& sums() const { return sums_; }
  const std::vector<LineSpread>& lines() const { return lines_; }

 private:
  const std::string scene_;
  const GoldenTracer tracer_;
  const GoldenTables tables_;
  const knob_values knobs_;
  std::vector<std::string> frames_;  // JSON texts
  frame_counts sums_;
  std::vector<LineSpread> lines_;
};

}  // namespace racebeam
