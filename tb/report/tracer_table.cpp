// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/tracer_table.h"

#include <fmt/format.h>

#include <cstring>

namespace racebeam {

namespace {

constexpr const char* Head = "{:>5}  {:<32}";
constexpr const char* Tail = " {:>10}  {:<8}\n";

std::string columns(const GoldenTables& tables, const frame_counts& counts) {
  std::string text;
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    if (const int width = tables.counters[n].column)
      text += fmt::format(" {:>{}}", counts.counters[n], width);
  return text;
}

/// A sum by its name.
double sum_of(const GoldenFrames& report, const char* name) {
  const auto& counters = report.tables().counters;
  for (std::size_t n = 0; n < counters.size(); ++n)
    if (std::strcmp(counters[n].name, name) == 0) return double(report.sums().counters[n]);
  return 0;
}

/// "before N after", or nothing if nothing was counted.
std::string ratio(const char* before, double part, double of, const char* after) {
  return of > 0 ? fmt::format("{}{:.2f}{}", before, part / of, after) : "";
}

}  // namespace

std::string tracer_header(const GoldenTables& tables) {
  std::string text = fmt::format(Head, "frame", "part");
  for (const counter_info& one : tables.counters)
    if (one.column) text += fmt::format(" {:>{}}", one.title, one.column);
  return text + fmt::format(Tail, "intervals", "image");
}

std::string tracer_row(const GoldenTables& tables, int frame, const std::string& part,
                       const frame_counts& counts, int stretches, const VgaFrame& picture) {
  return fmt::format(Head, frame, part) + columns(tables, counts) +
         fmt::format(Tail, stretches, fmt::format("{:08x}", picture.image_crc));
}

std::string tracer_total(const GoldenFrames& report) {
  return fmt::format(Head, "total", fmt::format("{} frames", report.frames())) +
         columns(report.tables(), report.sums()) + "\n";
}

std::string tracer_summary(const GoldenFrames& report) {
  std::string text;
  if (const double edges = sum_of(report, "edges"); edges > 0) {
    const double chattering = sum_of(report, "chattering_edges");
    text +=
        fmt::format("edges that switch more than once along a line: {:.0f} of {:.0f}, {:.2f} %\n",
                    chattering, edges, 100 * chattering / edges);
  }
  if (const double rays = sum_of(report, "rays"); rays > 0) {
    text += ratio("decisions: ", sum_of(report, "decisions"), rays, " a ray") +
            ratio(", ", sum_of(report, "crossing_decisions"), sum_of(report, "rooms_entered"),
                  " a room crossed") +
            ratio(", ", sum_of(report, "solid_decisions"), sum_of(report, "solid_hits"),
                  " at a solid wall") +
            "\n";
  }
  for (std::size_t n = 0; n < report.lines().size(); ++n) {
    const LineSpread& line = report.lines()[n];
    if (line.clocks.count() == 0) continue;
    text += fmt::format("{}: {:.1f}, at most {} (frame {}, y {})\n", report.tables().lines[n].title,
                        line.clocks.mean(), line.clocks.max(), line.worst_frame, line.worst_line);
  }
  return text;
}

}  // namespace racebeam
