// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_table.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace racebeam {

namespace {

constexpr const char* Head = "{:>5}  {:<32}";

std::string row(const engine& counter, const std::string& frame, const std::string& part,
                const frame_counts& stats, const std::vector<std::uint64_t>& line_sums) {
  std::string text = fmt::format(Head, frame, part);
  for (std::size_t n = 0; n < stats.counters.size(); ++n)
    if (const int width = counter.counters[n].column)
      text += fmt::format(" {:>{}}", stats.counters[n], width);
  for (std::size_t n = 0; n < line_sums.size(); ++n)
    if (const std::string title = counter.lines[n].title; !title.empty())
      text += fmt::format(" {:>{}}", line_sums[n], title.size());
  return text;
}

constexpr const char* GoldenColumn = " {:>14}";

std::string golden_column(const std::optional<GoldenCounts>& golden) {
  if (!golden) return "";
  const PictureErrors& errors = golden->errors;
  return errors.pixels ? fmt::format(GoldenColumn, errors.differing)
                       : fmt::format(GoldenColumn, golden->by_tracer[int(GoldenTracer::Trace4)]);
}

}  // namespace

std::string table_header(const engine& counter, bool crc, bool golden) {
  std::string text = fmt::format(Head, "frame", "part");
  for (const counter_info& one : counter.counters)
    if (one.column) text += fmt::format(" {:>{}}", one.title, one.column);
  for (const line_info& one : counter.lines)
    if (*one.title) text += fmt::format(" {}", one.title);
  return text +
         (golden ? fmt::format(GoldenColumn, counter.races_beam ? "not as trace4" : "not as golden")
                 : "") +
         (crc ? "  image    pins\n" : "\n");
}

std::string table_row(const engine& counter, int frame, const std::string& part,
                      const frame_counts& stats, const VgaFrame& picture, bool crc,
                      const std::optional<GoldenCounts>& golden) {
  std::vector<std::uint64_t> sums;
  for (const std::vector<int>& lines : stats.lines) {
    std::uint64_t sum = 0;
    for (const int clocks : lines) sum += clocks < 0 ? 0 : static_cast<std::uint64_t>(clocks);
    sums.push_back(sum);
  }
  return row(counter, std::to_string(frame), part, stats, sums) + golden_column(golden) +
         (crc ? fmt::format("  {:08x} {:08x}\n", picture.image_crc, picture.pins_crc) : "\n");
}

std::string table_total(const StatsReport& report) {
  std::vector<std::uint64_t> sums;
  for (const LineSpread& line : report.lines()) sums.push_back(line.clocks.sum());
  return row(report.counter(), "total", fmt::format("{} frames", report.frames()), report.sums(),
             sums) +
         golden_column(report.golden()) + "\n";
}

std::string line_account(const StatsReport& report) {
  std::string text;
  double all = 0;
  for (std::size_t n = 0; n < report.lines().size(); ++n) {
    const Spread& clocks = report.lines()[n].clocks;
    const std::string part = report.counter().lines[n].part;
    if (part.empty() || clocks.count() == 0) continue;
    text += fmt::format("{} {:.1f}, ", part, clocks.mean());
    all += clocks.mean();
  }
  return text.empty() ? "" : fmt::format("clocks of a line: {}in all {:.0f}\n", text, all);
}

namespace {

std::string errors_table(const PictureErrors& e) {
  const auto row = [](const char* name, const std::string& value, const char* unit) {
    return fmt::format("{:<24} {:>10}  {}\n", name, value, unit);
  };
  const auto share = [&](const char* name, std::uint64_t part) {
    return row(
        name, std::to_string(part),
        fmt::format("{:.2f} %", 100.0 * static_cast<double>(part) / static_cast<double>(e.pixels))
            .c_str());
  };
  return "\nthe chip beside double precision\n" + row("pixels", std::to_string(e.pixels), "") +
         share("differing", e.differing) + share("by more than one level", e.by_more) +
         share("wrong first hit", e.wrong_hits) +
         row("RMSE", fmt::format("{:.3f}", e.rmse()), fmt::format("levels of {}", e.most).c_str()) +
         row("PSNR", e.squares ? fmt::format("{:.1f}", e.psnr()) : "-", "dB");
}

}  // namespace

std::string golden_table(const GoldenCounts& counts) {
  if (counts.errors.pixels) return errors_table(counts.errors);
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
