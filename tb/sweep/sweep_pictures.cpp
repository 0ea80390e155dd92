// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/interrupt.h"
#include "tb/picture/picture_format.h"
#include "tb/sweep/export.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

constexpr int EveryFrame = 1 << 30;

/// One picture of a point.
struct Kept {
  int frame;
  std::string why, file;
};

std::vector<Kept> asked(const SweepPlan& plan, const SweepState& state, int point, int scene) {
  const SweepMeasure& measure = plan.file.measure;
  const SweepScene& of = plan.scenes[static_cast<std::size_t>(scene)];
  std::vector<Kept> all;
  for (const int frame : measure.pictures)
    if (frame < of.show.frames()) all.push_back({frame, "", ""});
  if (measure.worst_picture) {
    const PointReading errors =
        state.read(point, *figure_named("picture_error", *plan.file.built), EveryFrame);
    const Worst worst = worst_of({errors.reading.frames[static_cast<std::size_t>(scene)]});
    if (worst.frames > 0) all.push_back({worst.frame, "worst", ""});
  }
  const std::string& setting =
      plan.points[static_cast<std::size_t>(point)].settings[static_cast<std::size_t>(scene)];
  for (Kept& one : all)
    one.file = text_hash(fmt::format("{} {}\n{}", of.show.hash(), one.frame, setting)) + ".png";
  return all;
}

std::string file_of(const std::string& packed) {
  return picture_bytes(picture_formats().front(), unpacked_picture(packed));
}

}  // namespace

bool keep_pictures(const SweepPlan& plan, const SweepFolder& folder, Measurer& measurer,
                   const SweepState& state) {
  if (plan.file.measure.pictures.empty() && !plan.file.measure.worst_picture) return true;
  std::string index = "point,scene,frame,why,file\n";
  for (const int point : state.running())
    for (int scene = 0; scene < static_cast<int>(plan.scenes.size()); ++scene) {
      const std::vector<Kept> all = asked(plan, state, point, scene);
      Want want{point, scene, {}};
      for (const Kept& one : all)
        if (!folder.has_picture(one.file) &&
            std::find(want.frames.begin(), want.frames.end(), one.frame) == want.frames.end())
          want.frames.push_back(one.frame);
      const std::map<int, std::string> pictures = measurer.pictures(want);
      if (interrupted()) return false;
      for (const Kept& one : all) {
        if (const auto at = pictures.find(one.frame); at != pictures.end())
          folder.keep_picture(one.file, file_of(at->second));
        index += fmt::format("{},{},{},{},{}\n",
                             csv_cell(plan.points[static_cast<std::size_t>(point)].point.name),
                             csv_cell(plan.scenes[static_cast<std::size_t>(scene)].name), one.frame,
                             one.why, one.file);
      }
    }
  folder.keep_picture("index.csv", index);
  return true;
}

}  // namespace racebeam
