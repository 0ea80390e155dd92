// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "sc/constants.h"
#include "tb/nearest.h"
#include "tb/set_knob.h"

namespace racebeam {

namespace {

constexpr const char* DefaultFolder = "racebeam_out";
constexpr int MaxSheetFrames = 120;  // a sheet of 2500 x 8000 pixels
constexpr int MaxGifScale = 8;
constexpr int SoundClocksPerPixel = 2;

int checked(const char* option, long long value, long long min, long long max, const char* why) {
  if (value < min || value > max)
    throw UsageError(
        fmt::format("{} {} is out of range; {}: {}..{}", option, value, why, min, max));
  return static_cast<int>(value);
}

void check_known(const std::string& kind, const std::string& name,
                 const std::vector<std::string>& known) {
  for (const std::string& one : known)
    if (one == name) return;
  throw unknown_name(kind, name, known);
}

// Sound and pictures that would come out wrong.
void check_outputs(const RenderPlan& plan) {
  if (!plan.wav.empty() && plan.every != 1)
    throw UsageError("--wav needs consecutive frames; leave out --every, or --wav");
  if (!plan.wav.empty() && plan.k.clocks_per_pixel != SoundClocksPerPixel)
    throw UsageError(
        fmt::format("--wav needs clocks_per_pixel={}: the sound is clocked by the "
                    "beam; leave out --wav, or the knob",
                    SoundClocksPerPixel));
  if (!plan.sheet.empty() && plan.frames > MaxSheetFrames)
    throw UsageError(
        fmt::format("--sheet holds up to {} frames, not {}; use fewer --frames and "
                    "a larger --every",
                    MaxSheetFrames, plan.frames));
  std::set<std::string> seen;
  for (const std::string& path : {plan.gif, plan.wav, plan.sheet, plan.stats}) {
    if (path.empty()) continue;
    if (!seen.insert(std::filesystem::path(path).lexically_normal().string()).second)
      throw UsageError(path + " is named for two outputs; give each its own file");
  }
}

}  // namespace

int RenderPlan::frame(int index) const {
  return static_cast<int>((first + static_cast<long long>(index) * every) % DemoFrames);
}

RenderPlan plan_render(const RenderOptions& options) {
  check_known("scene", options.scene, {"demo"});
  check_known("level", options.level, {"signal"});
  RenderPlan plan{
      options.scene,
      options.level,
      checked("--frames", options.frames, 1, DemoFrames, "frames to render"),
      checked("--first", options.first, 0, DemoFrames - 1, "the demo has the frames"),
      checked("--every", options.every, 1, DemoFrames - 1, "frames from one to the next"),
      checked("--gif-scale", options.gif_scale, 1, MaxGifScale, "pixels made one"),
      {},
      options.folder,
      options.gif,
      options.wav,
      options.sheet,
      options.stats,
      options.crc,
      options.json,
      options.command};
  for (const std::string& assignment : options.assignments) set_knob(plan.k, assignment);
  check_outputs(plan);
  if ((plan.folder + plan.gif + plan.wav + plan.sheet + plan.stats).empty())
    plan.folder = DefaultFolder;
  return plan;
}

}  // namespace racebeam
