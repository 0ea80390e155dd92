// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/line_story.h"

#include "sc/beam/subdivider_core.h"

namespace racebeam {

const TracedInterval* LineStory::interval_of(int pixel) const {
  for (const TracedInterval& interval : intervals)
    if (interval.first <= pixel && pixel <= interval.last) return &interval;
  return nullptr;
}

StepTotals totals(const LineStory& story, const TracedInterval& interval) {
  StepTotals sums;
  for (std::size_t i = interval.step_begin; i < interval.step_end; ++i) {
    const TracerStep& step = story.steps[i];
    sums.pushes += step.pushes;
    sums.restarts += step.restarts && step.last != LastPixel;
    if (step.decision) {
      ++(step.state == StateLeft ? sums.left : step.state == StateRight ? sums.right : sums.bisect);
    } else if (step.offers && !step.emits) {
      sums.waits += step.clocks;
    } else if (step.offers || step.state == StateReturn) {
      sums.returns += step.clocks;
    } else {
      (step.second ? sums.room_changes : sums.walks) += step.clocks;
    }
  }
  return sums;
}

}  // namespace racebeam
