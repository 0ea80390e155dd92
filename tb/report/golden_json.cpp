// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/golden_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tb/show/knobs_json.h"

namespace racebeam {

using Json = nlohmann::ordered_json;

Json golden_json(const GoldenCounts& counts) {
  Json differing, causes;
  for (std::size_t i = 0; i < counts.by_tracer.size(); ++i)
    differing[golden_tracer_names()[i]] = counts.by_tracer[i];
  for (std::size_t i = 0; i < counts.by_cause.size(); ++i)
    causes[golden_causes()[i].name] = counts.by_cause[i];
  return {{"differing_pixels", differing}, {"causes", causes}};
}

GoldenFrames::GoldenFrames(std::string scene, std::string tracer, const knobs& k)
    : scene_(std::move(scene)), tracer_(std::move(tracer)), knobs_(k) {}

void GoldenFrames::add(int frame, const std::string& part, const VgaFrame& picture, bool crc) {
  Json json = {{"frame", frame}, {"part", part}};
  if (crc) json["image_crc32"] = fmt::format("{:08x}", picture.image_crc);
  frames_.push_back(json.dump());
}

std::string GoldenFrames::text() const {
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  return fmt::format(
      "{{\"schema\": \"racebeam-golden\", \"version\": 1,\n\"scene\": {}, \"tracer\": {},\n"
      "\"knobs\": {},\n\"frames\": [{}],\n\"total\": {{\"frames\":{}}}}}\n",
      Json(scene_).dump(), Json(tracer_).dump(), knobs_json(knobs_).dump(), rows, frames());
}

}  // namespace racebeam
