// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/front_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tb/base/counted.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/nsga2_library.h"

namespace racebeam {

namespace {

// Beyond any figure, and far apart: pagmo divides by the range of a goal, which stays finite.
constexpr double BeyondLimits = 1e50, Unusable = 1e100, FurthestOff = 1e6;

double value_of(const Reading& reading) {
  switch (reading.kind) {
    case Reading::Exact: return reading.exact;
    case Reading::Largest: return worst_of(reading.frames).value;
    case Reading::Sampled: break;
  }
  return mean_of(reading.frames).value;
}

// How far a value is beyond a goal's limits, in shares of the limit.
double off(const Goal& goal, double value) {
  const auto share = [](double by, double limit) {
    return std::max(by, 0.0) / (limit != 0 ? std::abs(limit) : 1);
  };
  double sum = 0;
  if (goal.most) sum += share(value - *goal.most, *goal.most);
  if (goal.least) sum += share(*goal.least - value, *goal.least);
  return std::min(sum, FurthestOff);
}

}  // namespace

std::vector<double> search_goals(const std::vector<Goal>& goals,
                                 const std::vector<Reading>& readings) {
  std::vector<double> told;
  double beyond = 0;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const double value = readings.empty() ? Unusable : value_of(readings[i]);
    if (!readings.empty()) beyond += off(goals[i], value);
    if (goals[i].kind == GoalKind::Limit) continue;
    told.push_back(goals[i].kind == GoalKind::Max && !readings.empty() ? -value : value);
  }
  if (beyond > 0) std::fill(told.begin(), told.end(), BeyondLimits * (1 + beyond));
  return told;
}

std::string search_front(SweepPlan& plan, const SearchOwner& owner) {
  const SweepSearch& setting = plan.file.search;
  Nsga2Search search;
  for (const KnobValues& knob : plan.file.knobs) search.values.push_back(knob.values.size());
  search.goals = search_goals(plan.file.goals, {}).size();
  search.generations = setting.generations;
  search.seed = setting.seed;
  std::size_t asked = 0, refused = 0;
  std::set<int> different;
  nsga2_library().search(search, plan.first, [&](const Generation& generation) {
    const std::vector<int> points = plan.add(generation);
    owner.measure();
    Goals goals;
    for (const int point : points) {
      ++asked;
      refused += point < 0;
      if (point >= 0) different.insert(point);
      goals.push_back(search_goals(plan.file.goals,
                                   point < 0 ? std::vector<Reading>() : owner.readings(point)));
    }
    return goals;
  });
  std::string text = fmt::format("nsga2 has asked for {}, {} of them different",
                                 counted(asked, "point"), different.size());
  if (refused > 0) text += fmt::format("; {} were refused by 'where'", refused);
  return text;
}

}  // namespace racebeam
