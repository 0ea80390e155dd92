// How a reported sweep was measured, as HTML.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/report/reported_sweep.h"

namespace racebeam {

/// Frames, seed, reference, intervals, tools, versions, hashes, runs, and the sweep file itself.
std::string report_method(const ReportedSweep& sweep);

}  // namespace racebeam
