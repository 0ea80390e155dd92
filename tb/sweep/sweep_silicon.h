// The silicon of a sweep's points: what has to be synthesised, and who gets which figures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/sweep/measurer.h"
#include "tb/sweep/silicon_plan.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

class SweepSilicon {
 public:
  /// `store`: nullptr if there is none yet. Without yosys there are no figures, which it says once;
  /// throws MissingTool if a goal needs them.
  /// What yosys has failed on in another run fails again, unless `fresh`: then it is tried.
  SweepSilicon(const SweepPlan& plan, Store* store, bool fresh = false);
  /// There is no yosys, and no goal that needs it.
  bool absent() const { return plan_.file.measure.silicon && !silicon_; }

  /// "; silicon: 25 unit syntheses (of 946 without sharing)"
  std::string plan_text() const;
  /// Synthesises what is missing, and gives the points their figures that have none yet. A point
  /// without them is refused if a goal needs them. Throws Interrupted.
  void measure(SweepState& state, Measurer& measurer, int jobs);

 private:
  bool needed() const;
  /// Plans the syntheses of the points that the plan has got.
  void want();

  const SweepPlan& plan_;
  Store* const store_;
  const bool fresh_;
  std::size_t wanted_ = 0, measured_ = 0;  // points
  std::optional<Silicon> silicon_{};
  std::optional<SiliconPlan> syntheses_{};
};

}  // namespace racebeam
