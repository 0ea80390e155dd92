// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_table.h"

#include <fmt/format.h>

#include <numeric>

namespace racebeam {

namespace {

constexpr const char* Row = "{:>5}  {:<32} {:>10} {:>10} {:>8} {:>14} {:>11} {:>11}";

std::string row(const std::string& frame, const std::string& part, const frame_stats& stats,
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

std::string table_row(int frame, const std::string& part, const frame_stats& stats,
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

std::string golden_table(const GoldenCounts& counts) {
  std::string text = "\npixels that differ from the golden tracers, and why\n";
  const auto row = [&](const std::string& name, int pixels, const std::string& meaning) {
    text += fmt::format("{:<20} {:>10}  {}\n", name, pixels, meaning);
  };
  // In difference_NNNN.png, by GoldenTracer; trace4 first.
  static const char* const colours[] = {"cyan, where trace4 agrees", "yellow",
                                        "magenta, where both agree"};
  for (const GoldenTracer tracer :
       {GoldenTracer::Trace4, GoldenTracer::Trace2, GoldenTracer::Geometry}) {
    const int i = static_cast<int>(tracer);
    row(golden_tracer_names()[i], counts.by_tracer[i],
        std::string("in difference_NNNN.png ") + colours[i]);
  }
  for (std::size_t i = 0; i < counts.by_cause.size(); ++i)
    if (counts.by_cause[i] > 0)
      row("  " + std::string(golden_causes()[i].name), counts.by_cause[i],
          golden_causes()[i].meaning);
  return text;
}

}  // namespace racebeam
