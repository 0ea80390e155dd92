// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/knob_effects.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace racebeam {

namespace {

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Measured points that differ in one knob alone, by its value.
using Family = std::map<int, const ReportedPoint*>;

std::vector<Family> families(const ReportedSweep& sweep, std::size_t knob) {
  std::map<std::vector<int>, Family> all;
  for (const ReportedPoint& point : sweep.points) {
    if (!point.measured()) continue;
    std::vector<int> others;
    for (const std::size_t other : sweep.knobs)
      if (other != knob) others.push_back(point.k.front()[other]);
    all[others].emplace(point.k.front()[knob], &point);
  }
  std::vector<Family> list;
  for (auto& [others, family] : all) list.push_back(std::move(family));
  return list;
}

std::vector<int> values_of(const ReportedSweep& sweep, std::size_t knob) {
  std::vector<int> values;
  for (const ReportedPoint& point : sweep.points)
    if (point.measured()) values.push_back(point.k.front()[knob]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

using Pair = std::pair<const ReportedPoint*, const ReportedPoint*>;

/// The mean over points, frame by frame; all have the same frames.
Strata average(const std::vector<Strata>& all) {
  Strata mean = all.front();
  for (std::size_t scene = 0; scene < mean.size(); ++scene)
    for (std::size_t i = 0; i < mean[scene].values.size(); ++i) {
      double sum = 0;
      for (const Strata& one : all) sum += one[scene].values[i];
      mean[scene].values[i] = sum / double(all.size());
    }
  return mean;
}

std::optional<Estimate> change_of(const std::vector<Pair>& pairs, std::size_t led) {
  std::vector<Strata> from, to;
  double exact = 0;
  for (const auto& [a, b] : pairs) {
    const PointReading &of_a = a->led[led], &of_b = b->led[led];
    if (!of_a.there || !of_b.there || of_a.reading.kind == Reading::Largest) return {};
    exact += (of_b.reading.exact - of_a.reading.exact) / double(pairs.size());
    from.push_back(of_a.reading.frames);
    to.push_back(of_b.reading.frames);
  }
  if (pairs.front().first->led[led].reading.kind == Reading::Exact) return Estimate{exact};
  Strata common = from.front();
  for (const auto* side : {&from, &to})
    for (const Strata& one : *side) common = on_same_frames(common, one).first;
  for (auto* side : {&from, &to})
    for (Strata& one : *side) one = on_same_frames(one, common).first;
  for (const Stratum& scene : common)
    if (scene.frames.empty()) return {};
  return difference_of(average(to), average(from));
}

/// Values of a knob that are looked at together.
struct ValueGroup {
  int from, to;
};

/// Each value, or if there are many, neighbours together, with about as many points each: a few
/// points with a value say little of it.
std::vector<ValueGroup> groups_of(const ReportedSweep& sweep, std::size_t knob) {
  constexpr std::size_t Most = 8;
  std::vector<ValueGroup> groups;
  const std::vector<int> values = values_of(sweep, knob);
  if (values.size() <= Most) {
    for (const int value : values) groups.push_back({value, value});
    return groups;
  }
  std::vector<int> all;
  for (const ReportedPoint& point : sweep.points)
    if (point.measured()) all.push_back(point.k.front()[knob]);
  std::sort(all.begin(), all.end());
  for (const int value : values) {
    const auto before = std::lower_bound(all.begin(), all.end(), value) - all.begin();
    const std::size_t place = static_cast<std::size_t>(before) * Most / all.size();
    if (groups.size() <= place) groups.push_back({value, value});
    groups.back().to = value;
  }
  return groups;
}

/// The values of a figure, of the points in a group.
std::vector<double> values_in(const ReportedSweep& sweep, std::size_t knob, const ValueGroup& group,
                              std::size_t led) {
  std::vector<double> values;
  for (const ReportedPoint& point : sweep.points) {
    const int value = point.k.front()[knob];
    const ReportedFigure* figure =
        point.measured() ? sweep.figure(point, sweep.led[led]->name) : nullptr;
    if (figure && value >= group.from && value <= group.to) values.push_back(figure->value.value);
  }
  return values;
}

}  // namespace

bool has_steps(const ReportedSweep& sweep) {
  const SearchMethod method = sweep.plan.file.search.method;
  return method == SearchMethod::Grid || method == SearchMethod::OneByOne;
}

std::vector<KnobStep> knob_steps(const ReportedSweep& sweep) {
  std::vector<KnobStep> steps;
  for (const std::size_t knob : sweep.knobs) {
    const std::vector<int> values = values_of(sweep, knob);
    const std::vector<Family> all = families(sweep, knob);
    for (std::size_t i = 1; i < values.size(); ++i) {
      std::vector<Pair> pairs;
      int most = 0;
      const auto frames = [](const Pair& pair) {
        return std::min(pair.first->frames, pair.second->frames);
      };
      for (const Family& family : all) {
        const auto from = family.find(values[i - 1]), to = family.find(values[i]);
        if (from == family.end() || to == family.end()) continue;
        pairs.emplace_back(from->second, to->second);
        most = std::max(most, frames(pairs.back()));
      }
      if (pairs.empty()) continue;
      const std::size_t found = pairs.size();
      pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                                 [&](const Pair& pair) { return frames(pair) < most; }),
                  pairs.end());
      const knob_row& row = sweep.built().knobs[knob];
      KnobStep step{row.name, row.text(values[i - 1]), row.text(values[i]),
                    static_cast<int>(pairs.size()), static_cast<int>(found - pairs.size())};
      for (std::size_t led = 0; led < sweep.led.size(); ++led)
        step.changes.push_back(change_of(pairs, led));
      steps.push_back(std::move(step));
    }
  }
  return steps;
}

PointsMean mean_over_points(const std::vector<double>& values, double confidence) {
  const double n = double(values.size()), mean = sum_of(values) / n;
  if (values.size() < 2)
    return {mean, std::numeric_limits<double>::infinity(), static_cast<int>(values.size())};
  double squares = 0;
  for (const double value : values) squares += std::pow(value - mean, 2);
  const double t = quantile(complement(boost::math::students_t(n - 1), (1 - confidence) / 2));
  return {mean, t * std::sqrt(squares / (n - 1) / n), static_cast<int>(values.size())};
}

std::vector<KnobMean> knob_means(const ReportedSweep& sweep) {
  std::vector<KnobMean> all;
  for (const std::size_t knob : sweep.knobs) {
    const knob_row& row = sweep.built().knobs[knob];
    for (const ValueGroup& group : groups_of(sweep, knob)) {
      KnobMean mean{row.name, row.text(group.from)};
      if (group.to != group.from) mean.value += ".." + row.text(group.to);
      for (std::size_t led = 0; led < sweep.led.size(); ++led) {
        const std::vector<double> values = values_in(sweep, knob, group, led);
        mean.means.push_back(values.empty() ? std::optional<PointsMean>()
                                            : mean_over_points(values));
      }
      all.push_back(std::move(mean));
    }
  }
  return all;
}

std::optional<double> eta_squared(const std::vector<std::vector<double>>& groups) {
  double sum = 0, count = 0, between = 0, all = 0;
  for (const auto& group : groups) {
    sum += sum_of(group);
    count += double(group.size());
  }
  for (const auto& group : groups) {
    if (group.empty()) continue;
    between +=
        double(group.size()) * std::pow(sum_of(group) / double(group.size()) - sum / count, 2);
    for (const double value : group) all += std::pow(value - sum / count, 2);
  }
  if (all == 0) return {};
  return between / all;
}

std::vector<KnobShare> knob_shares(const ReportedSweep& sweep) {
  std::vector<KnobShare> all;
  for (const std::size_t knob : sweep.knobs) {
    KnobShare share{sweep.built().knobs[knob].name};
    for (std::size_t led = 0; led < sweep.led.size(); ++led) {
      std::vector<std::vector<double>> groups;
      for (const ValueGroup& group : groups_of(sweep, knob))
        groups.push_back(values_in(sweep, knob, group, led));
      share.shares.push_back(eta_squared(groups));
    }
    all.push_back(std::move(share));
  }
  return all;
}

}  // namespace racebeam
