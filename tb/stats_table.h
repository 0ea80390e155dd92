// The table that `racebeam render` prints: one row per frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/frame_stats.h"
#include "tb/stats_json.h"
#include "tb/vga_monitor.h"

namespace racebeam {

/// Titles of the columns; with the CRCs if `crc`.
std::string table_header(bool crc);
std::string table_row(int frame, const std::string& part, const FrameStats& stats,
                      const VgaFrame& picture, bool crc);
/// The sums over all frames.
std::string table_total(const StatsReport& report);

}  // namespace racebeam
