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
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// {"differing_pixels": {"trace2": N, ...}, "causes": {"give_up": N, ...}}
nlohmann::ordered_json golden_json(const GoldenCounts& counts);

/// stats.json of a render by a golden tracer, schema "racebeam-golden" version 1: frames and their
/// checksums. There is no chip, so there are none of its counters.
class GoldenFrames {
 public:
  /// `tracer` is a name of golden_tracer_names().
  GoldenFrames(std::string scene, std::string tracer, const knobs& k);

  /// Adds a whole frame; with the CRC of its picture if `crc`.
  void add(int frame, const std::string& part, const VgaFrame& picture, bool crc);
  /// The whole document; one line per frame.
  std::string text() const;
  int frames() const { return static_cast<int>(frames_.size()); }

 private:
  const std::string scene_, tracer_;
  const knobs knobs_;
  std::vector<std::string> frames_;  // JSON texts
};

}  // namespace racebeam
