// The tables and sentences of a report, as HTML: what it says without a script.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/report_data.h"

namespace racebeam {

/// What the tables say, each sentence with its interval.
std::vector<std::string> report_sentences(const ReportedSweep& sweep, const ReportParts& parts);

/// The base and the front; without goals all points. "": nothing is measured.
std::string front_table(const ReportedSweep& sweep);
/// With several scenes: the figures of each.
std::string scenes_table(const ReportedSweep& sweep);
/// Steps of knobs, or means by value and shares.
std::string effects_table(const ReportedSweep& sweep, const ReportParts& parts);
std::string units_table(const ReportedSweep& sweep, const ReportParts& parts);
std::string slack_table(const ReportedSweep& sweep, const ReportParts& parts);
std::string causes_table(const ReportedSweep& sweep, const ReportParts& parts);
/// All points, with the command that repeats each.
std::string points_table(const ReportedSweep& sweep, const ReportPictures& pictures);

}  // namespace racebeam
