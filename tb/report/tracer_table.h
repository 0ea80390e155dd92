// The table that `racebeam render --golden TRACER` prints: one row per frame, and what it says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/report/golden_json.h"

namespace racebeam {

/// Titles of the columns, by golden_tables(); `stretches` of one colour and the checksum come last.
std::string tracer_header(const GoldenTables& tables);
std::string tracer_row(const GoldenTables& tables, int frame, const std::string& part,
                       const frame_counts& counts, int stretches, const VgaFrame& picture);
/// The sums over all frames.
std::string tracer_total(const GoldenFrames& report);
/// Ratios of the counters, in words; "" if the tracer counts nothing.
std::string tracer_summary(const GoldenFrames& report);

}  // namespace racebeam
