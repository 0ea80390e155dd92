// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tb/report/golden_json.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// To a thousandth.
double per(std::uint64_t count, std::uint64_t pixels) {
  return pixels
             ? std::round(1000.0 * static_cast<double>(count) / static_cast<double>(pixels)) / 1000
             : 0;
}

}  // namespace

StatsReport::StatsReport(const engine& counter, std::string scene, std::string level,
                         const knob_values& k)
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

Json StatsReport::json_of(const frame_counts& counts, const PictureTime& time,
                          std::uint64_t pixels) const {
  Json per_pixel = {{"clocks", per(time.clocks, pixels)}};
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    per_pixel[engine_.counters[n].name] = per(counts.counters[n], pixels);
  return {{"clocks", time.clocks},
          {"frames", time.frames},
          {"counters", counts_json(engine_.counters, engine_.histograms, knobs_, counts)},
          {"per_pixel", per_pixel}};
}

void StatsReport::add(int frame, const std::string& part, const frame_counts& stats,
                      const VgaFrame& picture, bool crc, const std::optional<GoldenCounts>& golden,
                      const PictureTime& time) {
  std::vector<LineSpread> lines(lines_.size());
  for (std::size_t n = 0; n < lines.size(); ++n) {
    lines[n].add(frame, stats.lines[n]);
    lines_[n].add(frame, stats.lines[n]);
  }
  Json json = {{engine_.races_beam ? "frame" : "picture", frame}, {"part", part}};
  json.update(engine_.races_beam ? json_of(stats, lines, false)
                                 : json_of(stats, time, picture.pixels()));
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
  time_.clocks += time.clocks;
  time_.frames += time.frames;
  pixels_ += picture.pixels();
}

std::string StatsReport::text(const std::string& against) const {
  const char* const unit = engine_.races_beam ? "frames" : "pictures";
  Json total = {{unit, frames()}};
  total.update(engine_.races_beam ? json_of(sums_, lines_, true) : json_of(sums_, time_, pixels_));
  if (golden_) total["golden"] = golden_json(*golden_);
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  return fmt::format(
      "{{\"schema\": \"racebeam-stats\", \"version\": 3, \"engine\": \"{}\",\n"
      "\"scene\": {}, \"level\": {},\n"
      "\"knobs\": {},\n\"{}\": [{}],\n\"total\": {}{}}}\n",
      engine_.name, Json(scene_).dump(), Json(level_).dump(), knobs_json(knobs_).dump(), unit, rows,
      total.dump(), against.empty() ? "" : ",\n\"against\": " + against);
}

}  // namespace racebeam
