// The table that `racebeam render` prints: one row per frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "sc/base/engine.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/report/stats_json.h"

namespace racebeam {

/// Titles of the columns, which the tables of the engine `counter` say; with the CRCs if `crc`,
/// with the pixels that differ from trace_4 if `golden`.
std::string table_header(const engine& counter, bool crc, bool golden = false);
std::string table_row(const engine& counter, int frame, const std::string& part,
                      const frame_counts& stats, const VgaFrame& picture, bool crc,
                      const std::optional<GoldenCounts>& golden = {});
/// The sums over all frames.
std::string table_total(const StatsReport& report);
/// "clocks of a line: camera 51.1, ..., in all 1600": what a visible line's clocks are spent on, on
/// average; "" if the engine does not say.
std::string line_account(const StatsReport& report);

/// Of a comparison: pixels that differ from each tracer, and why; what the colours of
/// difference_NNNN.png mean.
std::string golden_table(const GoldenCounts& counts);

}  // namespace racebeam
