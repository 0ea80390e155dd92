// The page of a sweep: one HTML file that needs nothing else, and reaches for nothing.
//
// Its Content-Security-Policy allows what is in the file, and no request. Tables and sentences are
// there without a script; the charts are drawn by it from report_data().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/report/reported_sweep.h"

namespace racebeam {

/// A page is so long at most, if the points' numbers and the pictures of the front leave that room:
/// the other pictures are left out before.
constexpr std::size_t ReportBytes = 3'000'000;

std::string report_page(const SweepReader& reader);

}  // namespace racebeam
