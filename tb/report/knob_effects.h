// What each knob of a sweep does to its figures.
//
// Of grids and single knobs: the change from each value to the next, over all pairs of points that
// differ in nothing else, on the frames that all of them have. Of points that a search has spread
// over the knobs: the mean of the points with each value, and how much of all differences a knob
// explains (eta squared).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/report/reported_sweep.h"

namespace racebeam {

struct KnobStep {
  std::string knob, from, to;
  int pairs = 0, left_out = 0;  ///< left out: pairs of which one stopped earlier than others
  std::vector<std::optional<Estimate>> changes{};  ///< by ReportedSweep::led
};
std::vector<KnobStep> knob_steps(const ReportedSweep& sweep);

/// The mean over points with an interval of Student's t.
struct PointsMean {
  double value = 0, half_width = 0;
  int points = 0;
};
PointsMean mean_over_points(const std::vector<double>& values, double confidence = Confidence);

struct KnobMean {
  std::string knob, value;                         ///< "4", or of many values "4..7"
  std::vector<std::optional<PointsMean>> means{};  ///< by ReportedSweep::led
};
std::vector<KnobMean> knob_means(const ReportedSweep& sweep);

/// Of the points' differences in a figure, what the groups explain: 0..1; none if all are alike.
std::optional<double> eta_squared(const std::vector<std::vector<double>>& groups);

struct KnobShare {
  std::string knob;
  std::vector<std::optional<double>> shares{};  ///< by ReportedSweep::led
};
std::vector<KnobShare> knob_shares(const ReportedSweep& sweep);

/// Whether points are a grid or single knobs, so that there are steps.
bool has_steps(const ReportedSweep& sweep);

}  // namespace racebeam
