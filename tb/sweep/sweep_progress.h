// SweepProgress: how far a sweep is, on a terminal and in status.json.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "tb/base/progress.h"
#include "tb/sweep/measurer.h"

namespace racebeam {

class SweepProgress {
 public:
  SweepProgress(const SweepPlan& plan, const SweepFolder& folder);

  /// Draws a bar, and once a second writes status.json. `rung`: frames of a point.
  void look(const Measurer& measurer, int rung);
  void end(const Measurer& measurer, int rung, bool whole);
  /// It goes on elsewhere.
  void leave(const Measurer& measurer, int rung);

 private:
  using Clock = std::chrono::steady_clock;
  void write(const Measurer& measurer, int rung, const char* state);

  const SweepPlan& plan_;
  const SweepFolder& folder_;
  Progress bar_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point written_{};
};

}  // namespace racebeam
