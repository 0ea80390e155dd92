// What is measured for the notes of a scene: counters of some frames, and why their pixels are not
// the ideal ones.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/judge/golden_compare.h"
#include "tb/judge/line_estimate.h"
#include "tb/report/stats_json.h"

namespace racebeam {

/// A counter of each frame.
struct FrameCounter {
  std::uint64_t sum = 0, worst = 0;
  int worst_frame = 0;  ///< the first of them

  void add(int frame, std::uint64_t value);
};

/// By the cores.
class SceneNotes {
 public:
  /// Estimates the worst line of all frames.
  SceneNotes(Show show, const knobs& k);

  /// Renders a frame and compares it with the golden tracers: takes seconds.
  void add(int frame);

  const Show& show() const { return show_; }
  const knobs& set_knobs() const { return knobs_; }
  const std::vector<int>& frames() const { return frames_; }
  const LineEstimate& estimate() const { return estimate_; }
  const LineSpread& busy_clocks() const { return busy_clocks_; }
  const FrameCounter& restarts() const { return restarts_; }
  const FrameCounter& starved_pixels() const { return starved_pixels_; }
  const FrameCounter& give_ups() const { return give_ups_; }
  const GoldenCounts& golden() const { return golden_; }
  /// Pixels that no cause accounts for: must be 0.
  int unexplained() const { return golden_.by_cause.back(); }

 private:
  const Show show_;
  const knobs knobs_;
  const LineEstimate estimate_;
  std::vector<int> frames_;
  LineSpread busy_clocks_;
  FrameCounter restarts_, starved_pixels_, give_ups_;
  GoldenCounts golden_;
};

}  // namespace racebeam
