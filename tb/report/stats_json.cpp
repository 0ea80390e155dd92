// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tb/report/golden_json.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

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

nlohmann::ordered_json StatsReport::json_of(const frame_counts& counts,
                                            const std::vector<LineSpread>& lines,
                                            bool whole_run) const {
  Json json = counts_json(engine_.counters, engine_.histograms, knobs_, counts);
  json.update(lines_json(engine_.lines, lines, whole_run));
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
  json.update(json_of(stats, lines, false));
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

std::string StatsReport::text(const std::string& against) const {
  Json total = {{"frames", frames()}};
  total.update(json_of(sums_, lines_, true));
  if (golden_) total["golden"] = golden_json(*golden_);
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  return fmt::format(
      "{{\"schema\": \"racebeam-stats\", \"version\": 2,\n\"scene\": {}, \"level\": {},\n"
      "\"knobs\": {},\n\"frames\": [{}],\n\"total\": {}{}}}\n",
      Json(scene_).dump(), Json(level_).dump(), knobs_json(knobs_).dump(), rows, total.dump(),
      against.empty() ? "" : ",\n\"against\": " + against);
}

}  // namespace racebeam
