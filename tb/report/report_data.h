// What the charts of a report are drawn from: the sweep's numbers, once, as columns.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/knob_effects.h"
#include "tb/report/report_pictures.h"
#include "tb/report/reported_sweep.h"

namespace racebeam {

/// A share of the visible pixels for each number of clocks, in steps of `step`.
struct SlackShares {
  std::size_t point = 0;
  std::vector<double> percent;  ///< of all pixels, by bin
};

/// What charts and tables show beside the points' figures.
struct ReportParts {
  std::vector<std::size_t> focus;  ///< the base, and points of the front: charts of few points
  int front_left_out = 0;          ///< of the front, for want of room in those charts
  std::vector<KnobStep> steps;
  std::vector<KnobMean> means;
  std::vector<KnobShare> shares;
  std::vector<SlackShares> slack;
  std::vector<const PointFigure*> causes;  ///< that are not 0 in all points of the focus
};
ReportParts report_parts(const SweepReader& reader);

/// "racebeam render demo --at 7223 --set fifo_entries=4 -o p7.png", for a shell. Of the first
/// scene, with the frame of its first picture, or else the first of the sample.
std::string repeat_command(const ReportedSweep& sweep, std::size_t point,
                           const ReportPictures& pictures);

/// JSON. Numbers have seven digits, as those of figures.csv.
std::string report_data(const ReportedSweep& sweep, const ReportParts& parts,
                        const ReportPictures& pictures);

}  // namespace racebeam
