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
#include "tb/program/common_options.h"
#include "tb/render/frame_renderer.h"
#include "tb/render/frame_sequence.h"
#include "tb/render/render_files.h"
#include "tb/render/render_golden.h"
#include "tb/render/render_tt.h"
#include "tb/render/sound_track.h"
#include "tb/report/stats_json.h"
#include "tb/report/stats_table.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

namespace {

// Simulates the planned frames; ends early when interrupted.
void render_frames(const RenderPlan& plan, FrameSequence& frames, SoundTrack* sound,
                   RenderFiles& files, StatsReport& report, Against& against) {
  Progress progress(plan.frames.count());
  const Raster raster = plan.raster();
  progress.draw(0, 0);
  if (!plan.json) print(table_header(plan.show.engine(), plan.crc, plan.compare));
  for (int i = 0; i < plan.frames.count() && !interrupted(); ++i) {
    const std::optional<RenderedFrame> frame = frames.next();
    if (!frame) break;
    const std::string part = plan.show.part(frame->number);
    if (sound) sound->play(frame->number);
    files.add(*frame, part);
    against.add(frame->number, frame->picture);
    report.add(frame->number, part, frame->stats, frame->picture, plan.crc, frame->golden,
               frame->time);
    progress.clear();
    if (!plan.json)
      print(table_row(plan.show.engine(), frame->number, part, frame->stats, frame->picture,
                      plan.crc, frame->golden));
    progress.draw(i + 1, plan.show.engine().races_beam
                             ? (i + 1LL) * raster.frame_clocks()
                             : static_cast<long long>(report.time().clocks));
  }
}

// Says how units in lockstep went. True if one differs.
bool report_locksteps(const RenderPlan& plan, const RenderOptions& options, const ChipBench& bench,
                      int frames) {
  std::string rest;
  for (const std::string& units : options.units) rest += " --use " + units;
  rest += options.set_text() + options.text() + options.delays_text();
  std::vector<int> rendered;
  for (int i = 0; i <= frames && i < plan.frames.count(); ++i)
    rendered.push_back(plan.frames.number(i));
  const Raster raster = plan.raster();
  bool differs = false;
  for (const Lockstep* unit : bench.locksteps()) {
    tell(fmt::format("{}: {} clocks compared, {} differ", unit->unit(), unit->clocks(),
                     unit->differences()));
    if (!unit->first()) continue;
    differs = true;
    const BeamPlace place = place_of(unit->first()->clock, rendered, raster);
    const std::string repeat =
        fmt::format("racebeam render {} --first {}{}", options.scene, place.frame, rest);
    const std::string closer = trace_command(
        options.scene,
        fmt::format("{}:{}", place.frame, plan.show.engine().races_beam ? FirstLine : 0),
        unit->unit(), rest);
    const std::string window =
        plan.folder.empty()
            ? ""
            : save_chip_window(*unit->first(), {plan.show, raster, rendered}, plan.k, plan.folder);
    tell_difference(explain(*unit->first(),
                            {"in " + (plan.show.engine().races_beam ? place_text(place, raster)
                                                                    : picture_text(place, raster)),
                             repeat, closer, window, knobs_text(plan.k)}));
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
  FrameSequence frames(plan.jobs, plan.frames.count(), [&]() -> FrameSequence::Render {
    chip = std::make_shared<FrameRenderer>(plan, alone && !plan.wav.empty());
    return [chip](int index) { return chip->render(index); };
  });
  Against against(plan.against);
  StatsReport report(plan.show.engine(), plan.show.name(), plan.level, plan.k);
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
  if (!plan.json) print(line_account(report));
  if (!plan.json && report.golden()) print(golden_table(*report.golden()));
  const bool wrong_units = chip && report_locksteps(plan, options, chip->bench(), report.frames());
  const bool differs = against.report(plan.json) || wrong_units;
  const bool whole = report.frames() == plan.frames.count();
  if (!whole || plan.writes()) tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  return differs ? ExitDifference : whole ? ExitGood : ExitInterrupted;
}

namespace {

void add_options(const CommandOptions& command, RenderOptions& options) {
  command
      .add_option("scene", options.scene,
                  "demo: the chip's own demo, 12799 frames; or a scene file")
      .type_name("SCENE");
  const auto number = [&](const char* name, long long& to, const char* range, const char* help) {
    add_number(command, name, to, help, is_number(name, range)).capture_default_str();
  };
  const auto file = [&](const char* name, std::string& to, const char* type, const char* help) {
    command.add_option(name, to, help).type_name(type).check(not_empty);
  };
  number("--frames", options.frames, FramesRange, "Frames to render");
  number("--first", options.first, FirstRange, "First frame, 0..12798");
  number("--every", options.every, "1..12798 in the demo", "Render only every Nth frame");
  command
      .add_option("--at", options.at,
                  "These frames, in this order, instead: 7223, or 5,700-720,3900")
      .type_name("FRAMES")
      .check(not_empty);
  number("--jobs", options.jobs, "1..256",
         "Processes that share the frames; the files are the same");
  command
      .add_option("--level", options.level,
                  "tlm: all cores in one loop behind TLM-2.0 sockets (default); signal: units "
                  "wired at 50.4 MHz (default with --use); both give the same")
      .type_name("LEVEL")
      .check(not_empty);
  add_run_options(command, options);
  command
      .add_option("--use", options.units,
                  "Put RTL in a unit's place: model, rtl, lockstep (both, compared), or a file; "
                  "UNIT may be all; several with commas; repeatable")
      .type_name("UNIT=IMPLEMENTATION")
      .repeatable();
  add_shake_options(command, options);
  add_delay_options(command, options);
  add_tt_options(command, options);
  file("-o,--output", options.folder, "DIR|FILE",
       "Folder for frame_0000.png ..., manifest.json, stats.json; racebeam_out if no file is "
       "asked for; or one picture, whose name says the format: F.png, F.exr");
  std::string formats = "Of the pictures in the folder";
  for (const PictureFormat& format : picture_formats())
    formats += fmt::format("; {}: {}", format.name, format.note);
  file("--format", options.format, "FORMAT", formats.c_str());
  command.add_flag("--overwrite", options.overwrite,
                   "Replace the frames of another render that the folder has; without it only "
                   "frames of the same settings are added");
  file("--gif", options.gif, "FILE",
       "Animated GIF at the chip's speed, 60 frames/s; with --every, at most 0.2 s "
       "a frame");
  number("--gif-scale", options.gif_scale, "1..8", "Shrink the GIF N times in both axes, 1..8");
  file("--wav", options.wav, "FILE", "Sound of consecutive frames");
  file("--sheet", options.sheet, "FILE",
       "Contact sheet of up to 120 frames, FILE.png or another picture format");
  file("--stats", options.stats, "FILE.json", "Statistics");
  file(
      "--vcd", options.vcd, "FILE",
      "Ports and wires of the chip as waveform, FILE.vcd or FILE.fst, with level signal; `racebeam "
      "trace` has windows and registers");
  command
      .add_option("--golden", options.golden,
                  "trace2, trace3, trace4, geometry: render with this golden tracer instead of the "
                  "chip, and count its work; compare: the chip, and why they differ")
      .type_name("TRACER")
      .check(not_empty);
  command
      .add_option("--show", options.show,
                  "picture (default); hits: what each pixel's ray meets first, a colour for each "
                  "wall, sphere or plane, of the chip or of --golden geometry")
      .type_name("WHAT")
      .check(not_empty);
  command
      .add_option("--overlay", options.overlays,
                  "slack, cost, depth: also maps of how early each pixel was known, what it cost, "
                  "how many rooms deep it looks: overlay_slack_0000.png ...; several with commas")
      .type_name("MAP")
      .repeatable();
  file("--against", options.against, "demo|FILE.csv",
       "Compare picture and pins of each frame with checksums: demo, those of the taped-out chip, "
       "or frame,image_crc32,pins_crc32 in a file");
  command.add_flag("--crc", options.crc, "Add CRC-32 of picture and pins to the statistics");
  command.add_flag("--json", options.json, "Statistics as JSON on stdout instead of the table");
}

}  // namespace

Command render_row() {
  return {"render", "Render frames as files and statistics", "See",
          "render demo --first 5000 --frames 60 --gif tunnel.gif",
          [](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<RenderOptions>();
            add_options(command, *options);
            return [options](const std::vector<std::string>& words) {
              options->command = words;
              return command_render(*options);
            };
          }};
}

}  // namespace racebeam
