// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render_tt.h"

#include <fmt/format.h>

#include <cmath>

#include "tb/console.h"
#include "tb/counted.h"
#include "tb/errors.h"
#include "tb/interrupt.h"
#include "tb/pins_report.h"
#include "tb/tt_plugin.h"
#include "tb/progress.h"
#include "tb/render_files.h"
#include "tb/tt_bench.h"

namespace racebeam {

namespace {

constexpr int MaxFrames = 1'000'000;  // to the end of the last one

struct TtPlan : OutputPlan {
  TtProject project;
  int ui, uio;
};

void refuse_scene_options(const RenderOptions& options) {
  const auto refuse = [](bool given, const char* what) {
    if (given) throw UsageError(std::string("--tt runs a chip of its own; leave out ") + what);
  };
  refuse(!options.scene.empty(), "the scene, or --tt");
  refuse(!options.assignments.empty(), "--set, or --tt");
  refuse(!options.units.empty(), "--use, or --tt");
  refuse(!options.golden.empty(), "--golden, or --tt");
  refuse(!options.level.empty(), "--level, or --tt");
  refuse(options.jobs > 1, "--jobs: it runs on from its reset");
}

int input_pins(const char* option, const std::optional<long long>& value) {
  if (value && (*value < 0 || *value > 255))
    throw UsageError(fmt::format("{} {} is out of range; eight pins: 0..255", option, *value));
  return static_cast<int>(value.value_or(0));
}

TtPlan plan_tt(const RenderOptions& options) {
  refuse_scene_options(options);
  TtPlan plan{plan_output(options, MaxFrames),
              {},
              input_pins("--ui", options.ui),
              input_pins("--uio", options.uio)};
  if (plan.first + static_cast<long long>(plan.frames - 1) * plan.every >= MaxFrames)
    throw UsageError(fmt::format("the last frame is beyond {}; every frame up to it is simulated",
                                 MaxFrames - 1));
  plan.project = read_tt_project(options.project, options.tt);
  return plan;
}

Manifest manifest_of(const TtPlan& plan) {
  Manifest manifest;
  manifest.scene = plan.project.folder;
  manifest.scene_hash = plan.project.hash;
  manifest.level = plan.project.top + ", verilated";
  return manifest;
}

/// What was assumed beside what the user named.
std::vector<std::string> remarks(const TtProject& project, const FoundFrames& found) {
  std::vector<std::string> all;
  for (const std::string& define : project.config_defines)
    all.push_back("src/config.json defines " + define);
  if (found.clock_assumed)
    all.push_back(fmt::format("{}: {} Hz assumed, since a line has {} clocks; --clock-hz sets it",
                              project.clock_hz == 0
                                  ? "the clock is not named"
                                  : fmt::format("a clock of {} Hz does not fit", project.clock_hz),
                              std::llround(found.clock_hz), found.raster.line_clocks()));
  if (!found.known_mode)
    all.push_back(
        fmt::format("{} are no mode with a name; the visible part, {}x{}, is estimated "
                    "from where it is not black",
                    found.mode, found.raster.columns, found.raster.rows));
  return all;
}

std::vector<std::string> told(const VgaFaults& faults) {
  std::vector<std::string> all;
  if (faults.sync_clocks)
    all.push_back(fmt::format("the syncs broke the mode in {}; first: {}",
                              counted(faults.sync_clocks, "clock"), faults.first_sync));
  if (faults.colour_clocks)
    all.push_back(fmt::format("colour outside of the visible pixels in {}; first: {}",
                              counted(faults.colour_clocks, "clock"), faults.first_colour));
  return all;
}

// Simulates all frames up to the last and keeps the planned ones; ends early when interrupted.
void render_frames(const TtPlan& plan, TtBench& bench, RenderFiles& files, PinsReport& report) {
  const int last = plan.first + (plan.frames - 1) * plan.every;
  Progress progress(last + 1);
  progress.draw(0, 0);
  if (!plan.json) print(report.table_header());
  for (int number = 0; number <= last && !interrupted(); ++number) {
    const TtBench::Frame frame = bench.render();
    if (number >= plan.first && (number - plan.first) % plan.every == 0) {
      files.add(number, plan.project.top, frame.picture);
      report.add(number, frame);
      progress.clear();
      if (!plan.json) print(report.table_row(number, frame));
    }
    progress.draw(number + 1, bench.clocks());
  }
}

}  // namespace

int render_tt(const RenderOptions& options) {
  TtPlan plan = plan_tt(options);
  catch_interrupts();
  TtChip chip(tt_plugin(plan.project, options.tt), plan.project.source_folder,
              plan.ui, plan.uio);
  TtBench bench(chip, plan.project, plan.crc, !plan.wav.empty(), plan.first);
  plan.frames_per_second = bench.found().frames_per_second();
  RenderFiles files(plan, manifest_of(plan));
  PinsReport report(plan.project, plan.ui, plan.uio, bench.found(), plan.crc);
  for (const std::string& remark : remarks(plan.project, bench.found())) tell(remark);
  files.run([&] { render_frames(plan, bench, files, report); }, bench.sound(),
            [&] { return report.text(bench.faults()); });
  print(plan.json ? report.text(bench.faults()) : report.table_pins());
  if (bench.sound() && !bench.has_sound_pin())
    tell("uio_oe[7] was never 1: the chip has no sound pin, and the sound is silence");
  const bool whole = report.frames() == plan.frames;
  tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  for (const std::string& fault : told(bench.faults())) tell(fault);
  if (!whole) return ExitInterrupted;
  return bench.faults().any() ? ExitDifference : ExitGood;
}

}  // namespace racebeam
