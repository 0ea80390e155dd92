// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/stats_table.h"

#include <fmt/format.h>

#include <numeric>

namespace racebeam {

namespace {

constexpr const char* Row = "{:>5}  {:<32} {:>10} {:>10} {:>8} {:>14} {:>11} {:>11}";

std::string row(const std::string& frame, const std::string& part, const FrameStats& stats,
                std::uint64_t busy_clocks) {
  return fmt::format(Row, frame, part, stats.decisions(), stats.bisection_steps, stats.restarts,
                     stats.starved_pixels, stats.fifo_full_stalls, busy_clocks);
}

constexpr const char* GoldenColumn = " {:>14}";

std::string golden_column(const std::optional<GoldenCounts>& golden) {
  return golden ? fmt::format(GoldenColumn, golden->by_tracer[int(GoldenTracer::Trace4)]) : "";
}

}  // namespace

std::string table_header(bool crc, bool golden) {
  return fmt::format(Row, "frame", "part", "decisions", "bisections", "restarts", "starved pixels",
                     "FIFO stalls", "busy clocks") +
         (golden ? fmt::format(GoldenColumn, "not as trace4") : "") +
         (crc ? "  image    pins\n" : "\n");
}

std::string table_row(int frame, const std::string& part, const FrameStats& stats,
                      const VgaFrame& picture, bool crc,
                      const std::optional<GoldenCounts>& golden) {
  const std::uint64_t busy =
      std::accumulate(stats.busy_clocks.begin(), stats.busy_clocks.end(), std::uint64_t{0});
  return row(std::to_string(frame), part, stats, busy) + golden_column(golden) +
         (crc ? fmt::format("  {:08x} {:08x}\n", picture.image_crc, picture.pins_crc) : "\n");
}

std::string table_total(const StatsReport& report) {
  return row("total", fmt::format("{} frames", report.frames()), report.sums(),
             report.busy_clocks()) +
         golden_column(report.golden()) + "\n";
}

}  // namespace racebeam
