// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_render.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/judge/against.h"
#include "tb/render/frame_renderer.h"
#include "tb/render/frame_sequence.h"
#include "tb/render/render_files.h"
#include "tb/render/render_golden.h"
#include "tb/render/render_tt.h"
#include "tb/render/sound_track.h"
#include "tb/report/stats_json.h"
#include "tb/report/stats_table.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

namespace {

// Simulates the planned frames; ends early when interrupted.
void render_frames(const RenderPlan& plan, FrameSequence& frames, SoundTrack* sound,
                   RenderFiles& files, StatsReport& report, Against& against) {
  Progress progress(plan.frames);
  std::uint64_t clocks = 0;
  progress.draw(0, 0);
  if (!plan.json) print(table_header(plan.crc, plan.compare));
  for (int i = 0; i < plan.frames && !interrupted(); ++i) {
    const std::optional<RenderedFrame> frame = frames.next();
    if (!frame) break;
    const std::string part = plan.show.part(frame->number);
    if (sound) sound->play(frame->number);
    files.add(*frame, part);
    against.add(frame->number, frame->picture);
    report.add(frame->number, part, frame->stats, frame->picture, plan.crc, frame->golden);
    progress.clear();
    if (!plan.json)
      print(table_row(frame->number, part, frame->stats, frame->picture, plan.crc, frame->golden));
    progress.draw(i + 1, clocks += frame->stats.clocks);
  }
}

// Says how units in lockstep went. True if one differs.
bool report_locksteps(const RenderPlan& plan, const RenderOptions& options, const ChipBench& bench,
                      int frames) {
  std::string rest;
  for (const std::string& units : options.units) rest += " --use " + units;
  for (const std::string& assignment : options.assignments) rest += " --set " + assignment;
  std::vector<int> rendered;
  for (int i = 0; i <= frames && i < plan.frames; ++i) rendered.push_back(plan.frame(i));
  const Raster raster(plan.k.clocks_per_pixel, plan.k.speed);
  bool differs = false;
  for (const Lockstep* unit : bench.locksteps()) {
    tell(fmt::format("{}: {} clocks compared, {} differ", unit->unit(), unit->clocks(),
                     unit->differences()));
    if (!unit->first()) continue;
    differs = true;
    const BeamPlace place = place_of(unit->first()->clock, rendered, raster);
    const std::string repeat =
        fmt::format("racebeam render {} --first {}{}", plan.scene, place.frame, rest);
    const std::string closer = trace_command(plan.scene, place.frame, unit->unit(), rest);
    const std::string window =
        plan.folder.empty()
            ? ""
            : save_chip_window(*unit->first(), {plan.show, raster, rendered}, plan.k, plan.folder);
    tell_difference(explain(*unit->first(),
                            {"in " + place_text(place, raster), repeat, closer, window, plan.k}));
  }
  return differs;
}

}  // namespace

int command_render(const RenderOptions& options) {
  if (!options.project.empty()) return render_tt(options);
  const RenderPlan plan = plan_render(options);
  catch_interrupts();
  if (plan.tracer) return render_golden(plan);
  RenderFiles files(plan, plan.manifest());
  // Several processes have no sound: it goes from frame to frame.
  const bool alone = plan.jobs == 1;
  std::optional<SoundTrack> track;
  if (!plan.wav.empty() && !alone) track.emplace(plan.k);
  std::shared_ptr<FrameRenderer> chip;  // of this process
  FrameSequence frames(plan.jobs, plan.frames, [&]() -> FrameSequence::Render {
    chip = std::make_shared<FrameRenderer>(plan, alone && !plan.wav.empty());
    return [chip](int index) { return chip->render(index); };
  });
  Against against(plan.against);
  StatsReport report(plan.show.name(), plan.level, plan.k);
  files.run(
      [&] {
        render_frames(plan, frames, track ? &*track : nullptr, files, report, against);
        if (chip) chip->finish();
      },
      track  ? &track->sound()
      : chip ? chip->bench().sound()
             : nullptr,
      [&] { return report.text(against.json()); });
  if (plan.json) print(report.text(against.json()));
  else if (report.frames() > 1) print(table_total(report));
  if (!plan.json && report.golden()) print(golden_table(*report.golden()));
  const bool wrong_units = chip && report_locksteps(plan, options, chip->bench(), report.frames());
  const bool differs = against.report(plan.json) || wrong_units;
  const bool whole = report.frames() == plan.frames;
  if (!whole || plan.writes()) tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  return differs ? ExitDifference : whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
