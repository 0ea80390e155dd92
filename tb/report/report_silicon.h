// The silicon of a reported sweep's points, from what its store knows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "tb/report/reported_sweep.h"

namespace racebeam {

/// The figures of designs, by point and figure; gives the points their units, or says in
/// ReportedSweep::no_units why there are none. Nothing is synthesised. What units do not tell comes
/// from the figures.csv of a sweep that is done.
std::map<std::string, std::map<std::string, double>> exact_figures(ReportedSweep& sweep,
                                                                   const SweepFolder& folder,
                                                                   const Store& store);

}  // namespace racebeam
