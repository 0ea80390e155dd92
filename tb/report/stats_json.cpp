// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "sc/base/constants.h"
#include "sc/beam/tlm/tlm_map.h"
#include "tb/report/golden_json.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;
using Histogram = std::array<std::uint64_t, 65>;

constexpr int Percentile = 99;

Json json_of(const Spread& spread) {
  if (spread.count() == 0) return nullptr;
  return {{"min", spread.min()},
          {"mean", std::round(spread.mean() * 1000) / 1000},
          {"max", spread.max()}};
}

Json json_of(const Histogram& histogram, int entries) {
  return std::vector<std::uint64_t>(histogram.begin(), histogram.begin() + entries + 1);
}

/// `whole_run`: name the worst line's frame too.
void put_lines(Json& to, const LineSpreads& lines, bool whole_run) {
  to["camera_clocks"] = json_of(lines.camera_clocks);
  Json& first_emit = to["first_emit_clock"] = json_of(lines.first_emit);
  if (!first_emit.is_null()) first_emit["lines_without"] = lines.lines_without_emit;
  Json& done = to["done_clock"] = json_of(lines.done_clock);
  if (done.is_null()) done = {{"min", nullptr}, {"mean", nullptr}, {"max", nullptr}};
  done["lines_not_done"] = lines.lines_not_done;
  Json& busy = to["busy_clocks"] = json_of(lines.busy_clocks);
  if (busy.is_null()) return;
  busy["p99"] = lines.busy_clocks.percentile(Percentile);
  busy["sum"] = lines.busy_clocks.sum();
  if (whole_run) busy["worst_frame"] = lines.worst_frame;
  busy["worst_line"] = lines.worst_line;
}

void put_stats(Json& to, const frame_stats& stats, const knobs& k) {
  for (const auto& [name, member] : counter_table()) {
    to[name] = stats.*member;
    if (member == &frame_stats::clocks) to["decisions"] = stats.decisions();
  }
  to["fifo_fill"] = json_of(stats.fifo_fill, k.fifo_entries);
  to["stack_depth"] = json_of(stats.stack_depth, k.interval_stack_depth);
}

}  // namespace

void LineSpreads::add(int frame, const frame_stats& stats) {
  const auto add_known = [](Spread& spread, const std::vector<int>& values) {
    int unknown = 0;
    for (const int value : values) {
      if (value < 0) ++unknown;
      else spread.add(value);
    }
    return unknown;
  };
  add_known(camera_clocks, stats.camera_clocks);
  lines_without_emit += add_known(first_emit, stats.first_emit);
  lines_not_done += add_known(done_clock, stats.done_clock);
  add_known(busy_clocks, stats.busy_clocks);
  for (std::size_t line = 0; line < stats.busy_clocks.size(); ++line) {
    if (stats.busy_clocks[line] <= worst_busy) continue;
    worst_busy = stats.busy_clocks[line];
    worst_frame = frame;
    worst_line = FirstVisibleLine + static_cast<int>(line);
  }
}

StatsReport::StatsReport(std::string scene, std::string level, const knobs& k)
    : scene_(std::move(scene)), level_(std::move(level)), knobs_(k) {}

void StatsReport::add(int frame, const std::string& part, const frame_stats& stats,
                      const VgaFrame& picture, bool crc,
                      const std::optional<GoldenCounts>& golden) {
  LineSpreads lines;
  lines.add(frame, stats);
  Json json = {{"frame", frame}, {"part", part}};
  put_stats(json, stats, knobs_);
  put_lines(json, lines, false);
  if (crc) {
    json["image_crc32"] = fmt::format("{:08x}", picture.image_crc);
    json["pins_crc32"] = fmt::format("{:08x}", picture.pins_crc);
  }
  if (golden) {
    json["golden"] = golden_json(*golden);
    if (!golden_) golden_.emplace();
    *golden_ += *golden;
  }
  frames_.push_back(json.dump());

  lines_.add(frame, stats);
  for (const auto& [name, member] : counter_table()) sums_.*member += stats.*member;
  for (std::size_t i = 0; i < stats.fifo_fill.size(); ++i) {
    sums_.fifo_fill[i] += stats.fifo_fill[i];
    sums_.stack_depth[i] += stats.stack_depth[i];
  }
}

std::string StatsReport::text(const std::string& against) const {
  Json total = {{"frames", frames()}};
  put_stats(total, sums_, knobs_);
  put_lines(total, lines_, true);
  if (golden_) total["golden"] = golden_json(*golden_);
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  return fmt::format(
      "{{\"schema\": \"racebeam-stats\", \"version\": 1,\n\"scene\": {}, \"level\": {},\n"
      "\"knobs\": {},\n\"frames\": [{}],\n\"total\": {}{}}}\n",
      Json(scene_).dump(), Json(level_).dump(), knobs_json(knobs_).dump(), rows, total.dump(),
      against.empty() ? "" : ",\n\"against\": " + against);
}

}  // namespace racebeam
