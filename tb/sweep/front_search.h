// The search of nsga2 in a sweep: what it asks for is planned, and what it is told of a point.
//
// It keeps nothing: it runs again from its seed, and is told the same, since all points have the
// same frames. So a run that goes on comes back to where the last one was stopped.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/sweep/front.h"
#include "tb/sweep/goal.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// What nsga2 is told of a point, for each goal with min or max; less is better. A point beyond
/// limits is worse in all of them than any point within, and the worse the further it is off, in
/// shares of the limits. `readings`: by goal; none: the point cannot be measured, or `where`
/// refuses it, and it is worse than all others.
std::vector<double> search_goals(const std::vector<Goal>& goals,
                                 const std::vector<Reading>& readings);

/// What becomes of what the search asks for. What these throw ends it.
struct SearchOwner {
  /// Measures the points that the plan has got.
  std::function<void()> measure;
  /// Of a point of the plan, by goal; none: it has failed.
  std::function<std::vector<Reading>(int point)> readings;
};

/// Searches to the end. In words: what it has asked for. Throws MissingTool without pagmo.
std::string search_front(SweepPlan& plan, const SearchOwner& owner);

}  // namespace racebeam
