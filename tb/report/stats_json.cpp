// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_json.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "sc/base/constants.h"
#include "tb/report/golden_json.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr int Percentile = 99;

Json json_of(const Spread& spread) {
  if (spread.count() == 0) return nullptr;
  return {{"min", spread.min()},
          {"mean", std::round(spread.mean() * 1000) / 1000},
          {"max", spread.max()}};
}

/// The values that can be.
Json json_of(const std::vector<std::uint64_t>& histogram, int most) {
  std::vector<std::uint64_t> values = histogram;
  values.resize(static_cast<std::size_t>(most) + 1);
  return values;
}

Json json_of(const LineSpread& line, const line_info& row, bool whole_run) {
  Json json = json_of(line.clocks);
  if (json.is_null() && !row.always) return json;
  if (json.is_null()) json = {{"min", nullptr}, {"mean", nullptr}, {"max", nullptr}};
  if (*row.without) json[row.without] = line.without;
  if (!*row.title) return json;
  json["p99"] = line.clocks.percentile(Percentile);
  json["sum"] = line.clocks.sum();
  if (whole_run) json["worst_frame"] = line.worst_frame;
  json["worst_line"] = line.worst_line;
  return json;
}

}  // namespace

void LineSpread::add(int frame, const std::vector<int>& lines) {
  for (std::size_t n = 0; n < lines.size(); ++n) {
    if (lines[n] < 0) ++without;
    else clocks.add(lines[n]);
    if (lines[n] <= worst) continue;
    worst = lines[n];
    worst_frame = frame;
    worst_line = FirstVisibleLine + static_cast<int>(n);
  }
}

StatsReport::StatsReport(const engine& counter, std::string scene, std::string level,
                         const knobs& k)
    : engine_(counter),
      scene_(std::move(scene)),
      level_(std::move(level)),
      knobs_(k),
      lines_(counter.lines.size()) {
  sums_.counters.resize(counter.counters.size());
  sums_.histograms.resize(counter.histograms.size());
}

nlohmann::ordered_json StatsReport::json_of_counts(const frame_counts& counts) const {
  Json json = Json::object();
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    json[engine_.counters[n].name] = counts.counters[n];
  for (std::size_t n = 0; n < counts.histograms.size(); ++n) {
    const histogram_info& row = engine_.histograms[n];
    json[row.name] = json_of(counts.histograms[n], row.largest(knobs_));
  }
  return json;
}

nlohmann::ordered_json StatsReport::json_of_lines(const std::vector<LineSpread>& lines,
                                                  bool whole_run) const {
  Json json = Json::object();
  for (std::size_t n = 0; n < lines.size(); ++n)
    json[engine_.lines[n].name] = json_of(lines[n], engine_.lines[n], whole_run);
  return json;
}

void StatsReport::add(int frame, const std::string& part, const frame_counts& stats,
                      const VgaFrame& picture, bool crc,
                      const std::optional<GoldenCounts>& golden) {
  std::vector<LineSpread> lines(lines_.size());
  for (std::size_t n = 0; n < lines.size(); ++n) {
    lines[n].add(frame, stats.lines[n]);
    lines_[n].add(frame, stats.lines[n]);
  }
  Json json = {{"frame", frame}, {"part", part}};
  json.update(json_of_counts(stats));
  json.update(json_of_lines(lines, false));
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
  sums_.add(stats);
}

std::vector<std::uint64_t> StatsReport::line_sums() const {
  std::vector<std::uint64_t> sums;
  for (const LineSpread& line : lines_) sums.push_back(line.clocks.sum());
  return sums;
}

std::string StatsReport::text(const std::string& against) const {
  Json total = {{"frames", frames()}};
  total.update(json_of_counts(sums_));
  total.update(json_of_lines(lines_, true));
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
