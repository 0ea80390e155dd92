// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/golden_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tb/show/knobs_json.h"

namespace racebeam {

using Json = nlohmann::ordered_json;

namespace {

/// To a thousandth.
double rounded(double value) { return std::round(1000 * value) / 1000; }

Json errors_json(const PictureErrors& e) {
  return {{"pixels", e.pixels},
          {"differing_pixels", e.differing},
          {"by_more_than_one_level", e.by_more},
          {"wrong_first_hits", e.wrong_hits},
          {"levels", e.most},
          {"rmse", rounded(e.rmse())},
          {"psnr", e.squares ? Json(rounded(e.psnr())) : Json()}};
}

}  // namespace

Json golden_json(const GoldenCounts& counts) {
  if (counts.errors.pixels) return errors_json(counts.errors);
  Json differing, causes;
  for (std::size_t i = 0; i < counts.by_tracer.size(); ++i)
    differing[golden_tracer_names()[i]] = counts.by_tracer[i];
  for (std::size_t i = 0; i < counts.by_cause.size(); ++i)
    causes[golden_causes()[i].name] = counts.by_cause[i];
  return {{"differing_pixels", differing}, {"causes", causes}};
}

GoldenFrames::GoldenFrames(std::string scene, GoldenTracer tracer, GoldenTables tables,
                           const knob_values& k)
    : scene_(std::move(scene)),
      tracer_(tracer),
      tables_(std::move(tables)),
      knobs_(k),
      lines_(tables_.lines.size()) {
  sums_.counters.resize(tables_.counters.size());
  sums_.histograms.resize(tables_.histograms.size());
}

void GoldenFrames::add(int frame, const std::string& part, const frame_counts& counts,
                       const VgaFrame& picture, bool crc) {
  std::vector<LineSpread> lines(lines_.size());
  for (std::size_t n = 0; n < lines.size(); ++n) {
    lines[n].add(frame, counts.lines[n]);
    lines_[n].add(frame, counts.lines[n]);
  }
  Json json = {{"frame", frame}, {"part", part}};
  json.update(counts_json(tables_.counters, tables_.histograms, knobs_, counts));
  json.update(lines_json(tables_.lines, lines, false));
  if (crc) json["image_crc32"] = fmt::format("{:08x}", picture.image_crc);
  frames_.push_back(json.dump());
  sums_.add(counts);
}

std::string GoldenFrames::text() const {
  Json total = {{"frames", frames()}};
  total.update(counts_json(tables_.counters, tables_.histograms, knobs_, sums_));
  total.update(lines_json(tables_.lines, lines_, true));
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  return fmt::format(
      "{{\"schema\": \"racebeam-golden\", \"version\": 2,\n\"scene\": {}, \"tracer\": {},\n"
      "\"knobs\": {},\n\"frames\": [{}],\n\"total\": {}}}\n",
      Json(scene_).dump(), Json(golden_tracer_names()[static_cast<int>(tracer_)]).dump(),
      knobs_json(knobs_).dump(), rows, total.dump());
}

}  // namespace racebeam
