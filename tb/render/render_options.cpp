// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>

#include "tb/base/console.h"
#include "tb/base/nearest.h"
#include "tb/base/output_file.h"
#include "tb/bench/benches.h"
#include "tb/judge/goldens.h"
#include "tb/render/output_folder.h"
#include "tb/render/picture_plan.h"
#include "tb/render/unit_files.h"
#include "tb/show/level.h"
#include "tb/show/open_show.h"
#include "tb/wave/wave_file.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr int MaxSheetFrames = 120;  // a sheet of 2500 x 8000 pixels
constexpr int MaxGifScale = 8;
constexpr int MaxJobs = 256;
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

// "slack,cost" and more of them.
std::vector<MapKind> maps_of(const std::vector<std::string>& overlays) {
  std::vector<std::string> known;
  for (const MapKind kind : MapKinds) known.push_back(map_name(kind));
  std::vector<MapKind> maps;
  for (const std::string& names : overlays) {
    std::istringstream parts(names);
    for (std::string name; std::getline(parts, name, ',');) {
      check_known("overlay", name, known);
      const MapKind kind = MapKinds[std::find(known.begin(), known.end(), name) - known.begin()];
      if (std::find(maps.begin(), maps.end(), kind) == maps.end()) maps.push_back(kind);
    }
  }
  return maps;
}

std::optional<GoldenTracer> tracer_of(const std::string& name) {
  if (name.empty() || name == Compare) return {};
  const auto& tracers = golden_tracer_names();
  std::vector<std::string> known = tracers;
  known.push_back(Compare);
  check_known("golden tracer", name, known);
  return static_cast<GoldenTracer>(std::find(tracers.begin(), tracers.end(), name) -
                                   tracers.begin());
}

// A name may have no extension, but not one of another format.
void check_extension(const char* option, const std::string& path, const char* extension) {
  const std::string own = extension_of(path);
  if (!own.empty() && own != extension)
    throw UsageError(fmt::format("{} writes {}; rename {}", option, extension, path));
}

// Of a show of so many frames.
FramePlan planned_frames(const RenderOptions& options, int frames) {
  if (!options.at.empty()) {
    if (options.frames != 1 || options.first != 0 || options.every != 1)
      throw UsageError("--at lists the frames; leave out --frames, --first and --every, or --at");
    return {options.at, frames};
  }
  const int last = frames - 1;
  return {checked("--frames", options.frames, 1, frames, "frames to render"),
          checked("--first", options.first, 0, last, "the scene has the frames"),
          checked("--every", options.every, 1, std::max(1, last), "frames from one to the next"),
          frames};
}

// Sound and pictures that would come out wrong.
void check_outputs(const OutputPlan& plan) {
  if (!plan.wav.empty() && plan.frames.every() != 1)
    throw UsageError("--wav needs consecutive frames; leave out --every or --at, or --wav");
  if (!plan.sheet.empty() && plan.frames.count() > MaxSheetFrames)
    throw UsageError(
        fmt::format("--sheet holds up to {} frames, not {}; use fewer --frames and "
                    "a larger --every",
                    MaxSheetFrames, plan.frames.count()));
  check_extension("--gif", plan.gif, ".gif");
  check_extension("--wav", plan.wav, ".wav");
  if (const std::string own = extension_of(plan.sheet); !own.empty() && !format_of_file(plan.sheet))
    picture_format(own.substr(1));
  check_extension("--stats", plan.stats, ".json");
}

// What a waveform of whole frames needs.
void check_wave(const RenderPlan& plan) {
  if (plan.vcd.empty()) return;
  check_waveform_name(plan.vcd);
  if (plan.tracer) throw UsageError("--vcd needs the chip; leave out --golden, or --vcd");
  if (!plan.frames.consecutive() || plan.jobs != 1)
    throw UsageError(
        "--vcd needs consecutive frames up to the end of the show, in one process; leave out "
        "--every and --jobs, or --vcd");
}

// What not every engine has.
void check_engine(const RenderOptions& options, const RenderPlan& plan) {
  const engine& built = plan.show.engine();
  if (!plan.overlays.empty() && !bench_of(built).intervals)
    throw UsageError(
        fmt::format("--overlay shows intervals; {} has none: leave out --overlay", built.name));
  if (options.against == "demo") expect_rooms(plan.show, "--against demo");
  if (options.golden.empty() || plan.show.of_rooms()) return;
  if (!golden_of(built)) expect_rooms(plan.show, "--golden");
  if (plan.tracer && *plan.tracer != GoldenTracer::Geometry)
    throw UsageError(
        fmt::format("--golden {} is for scenes of box rooms; of {} there is geometry, "
                    "in double precision, and compare",
                    options.golden, built.name));
}

// Maps have no checksums, and there is one golden map.
void check_show(const RenderOptions& options, RenderPlan& plan) {
  if (options.show.empty()) return;
  check_known("picture", options.show, {ShowPicture, ShowHits});
  plan.hits = options.show == ShowHits;
  if (!plan.hits) return;
  if (plan.against || plan.compare)
    throw UsageError(
        fmt::format("--show hits draws no colours that could be compared; leave out "
                    "{}, or see `racebeam compare`",
                    plan.against ? "--against" : "--golden compare"));
  if (plan.tracer && *plan.tracer != GoldenTracer::Geometry)
    throw UsageError("--show hits has one golden map: --golden geometry");
}

// What wires are needed for.
void check_delays(const RenderOptions& options, RenderPlan& plan) {
  if (options.delays.empty()) return;
  if (plan.tracer) throw UsageError("--delays needs the chip; leave out --golden, or --delays");
  if (plan.level != LevelSignal)
    throw UsageError(
        "--delays puts registers into wires of --level signal; tlm has none: leave out --level "
        "tlm, or --delays");
  check_delays(plan.show.engine(), options, options, options.units, plan.units);
}

// What stalls need.
void check_stalls(const RenderPlan& plan) {
  if (!plan.stalls) return;
  if (plan.tracer) throw UsageError("--shake needs the chip; leave out --golden, or --shake");
  if (plan.level != LevelSignal)
    throw UsageError(
        "--shake stalls wires of --level signal; tlm has none: leave out --level tlm, or --shake");
  if (plan.jobs != 1 && !plan.show.engine().races_beam)
    throw UsageError("stalls go on from picture to picture; leave out --jobs, or --shake");
}

// What several processes cannot do.
void check_jobs(const RenderPlan& plan) {
  if (plan.jobs == 1) return;
  for (const auto& [unit, choice] : plan.units.by_unit)
    if (choice.lockstep)
      throw UsageError("a comparison in lockstep runs in one process; leave out --jobs, or use " +
                       unit + "=rtl");
}

// What only the chip's own sound can do.
void check_sound(const RenderPlan& plan) {
  if (!plan.wav.empty() && plan.tracer)
    throw UsageError("--wav needs the chip; leave out --golden, or --wav");
  const engine& built = plan.show.engine();
  if (!plan.wav.empty() && !bench_of(built).sound)
    throw UsageError(fmt::format("--wav: {} has no sound; leave out --wav", built.name));
  if (!plan.wav.empty() && built.video(plan.k).clocks_per_pixel != SoundClocksPerPixel)
    throw UsageError(
        fmt::format("--wav needs clocks_per_pixel={}: the sound is clocked by the "
                    "beam; leave out --wav, or the knob",
                    SoundClocksPerPixel));
}

// A reference of other frames would compare nothing.
void check_against(const OutputPlan& plan) {
  for (int i = 0; i < plan.frames.count(); ++i)
    if (plan.against->find(plan.frames.number(i))) return;
  throw UsageError(fmt::format("--against {} has none of these frames; it has {}",
                               plan.against->name(), plan.against->extent()));
}

// No file may overwrite another, or one that the folder gets anyway.
void check_distinct(const OutputPlan& plan) {
  const auto real = [](const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path), ignored);
  };
  std::set<fs::path> seen;
  for (const std::string& path :
       {plan.picture, plan.gif, plan.wav, plan.sheet, plan.stats, plan.vcd}) {
    if (path.empty() || fs::is_other(path)) continue;
    const fs::path file = real(path);
    if (!seen.insert(file).second)
      throw UsageError(path + " is named for two outputs; give each its own file");
    if (plan.folder.empty() || file.parent_path() != real(plan.folder)) continue;
    const std::string name = file.filename().string();
    const bool same_stats = name == "stats.json" && path == plan.stats;
    if (OutputFolder::owns(name) && !same_stats)
      throw UsageError(path + " is a name that the folder " + plan.folder +
                       " needs itself; choose another");
  }
}

// Frames beyond the last one are those from the start.
void tell_of_wrap(const RenderPlan& plan) {
  if (plan.frames.goes_round())
    tell(fmt::format("the show has frames 0..{} and starts again: the last one is frame {}",
                     plan.show.frames() - 1, plan.frames.number(plan.frames.count() - 1)));
}

}  // namespace

Manifest RenderPlan::manifest() const {
  Manifest manifest;
  manifest.scene = show.name();
  manifest.scene_hash = show.hash();
  manifest.level = level;
  manifest.k = k;
  manifest.units = unit_files;
  if (stalls)
    for (const stall_plan::channel& channel : stalls->channels)
      manifest.channels[channel.name] =
          fmt::format("shake {},{},{}", stalls->seed, stalls->begin, stalls->go_on);
  if (delays)
    for (const delay_plan::channel& channel : delays->channels)
      manifest.channels[channel.name] =
          fmt::format("latency {}, capacity {}", channel.latency, channel.capacity);
  return manifest;
}

OutputPlan plan_output(const RenderOptions& options, int frames) {
  OutputPlan plan{planned_frames(options, frames),
                  checked("--gif-scale", options.gif_scale, 1, MaxGifScale, "pixels made one"),
                  checked("--jobs", options.jobs, 1, MaxJobs, "processes"),
                  {},
                  options.gif,
                  options.wav,
                  options.sheet,
                  options.stats,
                  options.crc,
                  options.json,
                  options.command};
  plan.vcd = options.vcd;
  plan.overwrite = options.overwrite;
  check_outputs(plan);
  plan.overlays = maps_of(options.overlays);
  if (!plan.overlays.empty() && (!options.project.empty() || tracer_of(options.golden)))
    throw UsageError("--overlay needs the model of the chip; leave out --golden or --tt, or it");
  if (!options.against.empty()) {
    plan.against = std::make_shared<ReferenceFrames>(options.against);
    check_against(plan);
  }
  plan_pictures(plan, options);
  check_distinct(plan);
  return plan;
}

RenderPlan plan_render(const RenderOptions& options) {
  if (options.scene.empty())
    throw UsageError("scene is required, or --tt; `racebeam render --help` shows what it takes");
  refuse_tt_options(options);
  const Run run =
      open_run(options, !options.vcd.empty() || !options.shake.empty() || !options.delays.empty());
  if (run.level == LevelTlm && !options.vcd.empty())
    throw UsageError(
        "--vcd shows the wires of --level signal; leave out --level tlm, or see `racebeam trace "
        "--level tlm`");
  RenderPlan plan{run, plan_output(options, run.show.frames()), tracer_of(options.golden),
                  options.golden == Compare};
  plan.stalls = stall_plan_of(run.show.engine(), options);
  plan.delays = delay_plan_of(run.show.engine(), options);
  check_stalls(plan);
  tell_of_wrap(plan);
  if (plan.tracer) plan.level = "golden " + options.golden;
  use_units(plan, options.units, false, options.shake.empty() && options.delays.empty());
  leave_out_whole_chip(plan.show.engine(), options, options.units, plan.units);
  check_delays(options, plan);
  plan.unit_files = unit_files(plan.units, options.units);
  if (plan.tracer && !plan.units.by_unit.empty())
    throw UsageError("--use needs the chip; leave out --golden, or --use");
  if (plan.tracer && plan.against)
    throw UsageError("--against needs the chip; leave out --golden, or --against");
  check_engine(options, plan);
  check_show(options, plan);
  check_sound(plan);
  check_wave(plan);
  check_jobs(plan);
  return plan;
}

}  // namespace racebeam
