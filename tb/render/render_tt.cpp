// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/render_tt.h"

#include <fmt/format.h>

#include <optional>

#include "tb/base/console.h"
#include "tb/base/content_hash.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/judge/against.h"
#include "tb/render/render_files.h"
#include "tb/trace/tile_wave.h"
#include "tb/tt/pins_report.h"
#include "tb/tt/tt_bench.h"
#include "tb/tt/tt_plugin.h"
#include "tb/tt/tt_remarks.h"

namespace racebeam {

namespace {

struct TtPlan : OutputPlan {
  TtReading reading;
  TtProject project;
  TtInputs inputs;
};

void refuse_scene_options(const RenderOptions& options) {
  refuse_with_tt(!options.scene.empty(), "the scene, or --tt");
  refuse_with_tt(!options.assignments.empty(), "--set, or --tt");
  refuse_with_tt(!options.units.empty(), "--use, or --tt");
  refuse_with_tt(!options.text().empty(), "--shake and --stall, or --tt");
  refuse_with_tt(!options.delays.empty(), "--delays, or --tt");
  refuse_with_tt(!options.golden.empty(), "--golden, or --tt");
  refuse_with_tt(!options.level.empty(), "--level, or --tt");
  refuse_with_tt(!options.at.empty(), "--at: it runs on from its reset");
  refuse_with_tt(options.jobs > 1, "--jobs: it runs on from its reset");
}

TtPlan plan_tt(const RenderOptions& options) {
  refuse_scene_options(options);
  TtPlan plan{plan_output(options, MostTtFrames), options.reading, {}, tt_inputs(options)};
  if (plan.frames.goes_round())
    throw UsageError(fmt::format("the last frame is beyond {}; every frame up to it is simulated",
                                 MostTtFrames - 1));
  if (!plan.vcd.empty()) check_waveform_name(plan.vcd);
  if (!plan.vcd.empty() && plan.frames.every() != 1)
    throw UsageError("--vcd needs consecutive frames; leave out --every, or --vcd");
  plan.project = read_tt_project(options.project, options.reading);
  return plan;
}

Manifest manifest_of(const TtPlan& plan) {
  Manifest manifest;
  manifest.scene = plan.project.folder;
  manifest.scene_hash = plan.project.hash;
  manifest.level = plan.project.top + ", verilated";
  manifest.inputs = {{"ui_in", std::to_string(plan.inputs.start().ui)},
                     {"uio_in", std::to_string(plan.inputs.start().uio)}};
  if (const TtReading& reading = plan.reading; reading.clock_hz)
    manifest.inputs["clock_hz"] = std::to_string(*reading.clock_hz);
  if (!plan.reading.defines.empty())
    manifest.inputs["defines"] = fmt::format("{}", fmt::join(plan.reading.defines, " "));
  if (!plan.reading.include_folders.empty())
    manifest.inputs["include"] = fmt::format("{}", fmt::join(plan.reading.include_folders, " "));
  if (!plan.inputs.changes().empty()) manifest.inputs["changes"] = content_hash(plan.inputs.text());
  return manifest;
}

// Simulates all frames up to the last and keeps the planned ones; ends early when interrupted.
void render_frames(const TtPlan& plan, TtBench& bench, RenderFiles& files, PinsReport& report,
                   Against& against) {
  const int last = plan.frames.number(plan.frames.count() - 1);
  Progress progress(last + 1);
  progress.draw(0, 0);
  if (!plan.json) print(report.table_header());
  for (int number = 0; number <= last && !interrupted(); ++number) {
    const TtBench::Frame frame = bench.render();
    if (number >= plan.frames.first() &&
        (number - plan.frames.first()) % plan.frames.every() == 0) {
      files.add(number, plan.project.top, frame.picture);
      report.add(number, frame);
      against.add(number, frame.picture);
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
  TtRun run(plan.project, tt_plugin(plan.project, options.reading.trust), plan.inputs);
  plan.frames_per_second = run.found().frames_per_second();
  RenderFiles files(plan, manifest_of(plan));
  std::optional<TileWave> wave;
  if (!plan.vcd.empty()) wave.emplace(run, plan.project.top, plan.frames.first(), plan.vcd);
  TtBench bench(run, plan.checksums(), !plan.wav.empty(), plan.frames.first());
  Against against(plan.against);
  PinsReport report(plan.project, plan.inputs, run.found(), plan.crc);
  for (const std::string& remark : assumptions(plan.project, run.found())) tell(remark);
  files.run([&] { render_frames(plan, bench, files, report, against); }, bench.sound(),
            [&] { return report.text(bench.faults(), against.json()); });
  if (wave) wave->commit();
  print(plan.json ? report.text(bench.faults(), against.json()) : report.table_pins());
  const bool differs = against.report(plan.json);
  if (bench.sound() && !bench.has_sound_pin())
    tell("uio_oe[7] was never 1: the chip has no sound pin, and the sound is silence");
  const bool whole = report.frames() == plan.frames.count();
  if (!whole || plan.writes()) tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  for (const std::string& fault : complaints(bench.faults())) tell(fault);
  if (differs || bench.faults().any()) return ExitDifference;
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
