// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/command_render.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "tb/console.h"
#include "tb/errors.h"
#include "tb/golden/golden_compare.h"
#include "tb/interrupt.h"
#include "tb/lockstep_report.h"
#include "tb/progress.h"
#include "tb/render_files.h"
#include "tb/render_golden.h"
#include "tb/render_tt.h"
#include "tb/signal_bench.h"
#include "tb/stats_json.h"
#include "tb/stats_table.h"
#include "tb/tlm_bench.h"

namespace racebeam {

namespace {

std::unique_ptr<ChipBench> make_bench(const RenderPlan& plan) {
  const bool sound = !plan.wav.empty();
  if (plan.level == LevelTlm)
    return std::make_unique<TlmBench>(
        TlmBench::Options{plan.k, true, plan.crc, sound, plan.show.program(), nullptr});
  return std::make_unique<SignalBench>(SignalBench::Options{
      plan.k, true, plan.crc, sound, plan.show.program(), plan.units, !plan.overlays.empty()});
}

// Simulates the planned frames; ends early when interrupted.
void render_frames(const RenderPlan& plan, ChipBench& bench, RenderFiles& files,
                   StatsReport& report) {
  Progress progress(plan.frames);
  const Raster raster(plan.k.clocks_per_pixel, plan.k.speed);
  progress.draw(0, 0);
  if (!plan.json) print(table_header(plan.crc, plan.compare));
  for (int i = 0; i < plan.frames && !interrupted(); ++i) {
    bench.seek(plan.frame(i));
    const ChipBench::Frame frame = bench.render();
    const std::string part = plan.show.part(frame.number);
    files.add(frame.number, part, frame.picture);
    files.add_overlays(frame.number, frame.intervals, raster);
    std::optional<GoldenCounts> golden;
    if (plan.compare) {
      const GoldenReport found =
          golden_compare(plan.show, frame.number, plan.k, frame.picture.colours);
      golden = found.counts;
      files.add_difference(frame.number, found.difference);
    }
    report.add(frame.number, part, *frame.stats, frame.picture, plan.crc, golden);
    progress.clear();
    if (!plan.json)
      print(table_row(frame.number, part, *frame.stats, frame.picture, plan.crc, golden));
    progress.draw(i + 1, bench.clocks());
  }
}

// Says how units in lockstep went. True if one differs.
bool report_locksteps(const RenderPlan& plan, const std::vector<std::string>& assignments,
                      const ChipBench& bench, int frames) {
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
    std::string repeat = fmt::format("racebeam render {} --first {} --use {}=lockstep", plan.scene,
                                     place.frame, unit->unit());
    for (const std::string& assignment : assignments) repeat += " --set " + assignment;
    const std::string window =
        plan.folder.empty() ? "" : save_window(*unit->first(), "chip", plan.k, plan.folder);
    tell(explain(*unit->first(), {"in " + place_text(place, raster), repeat, window, plan.k}));
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
  const std::unique_ptr<ChipBench> chip = make_bench(plan);
  ChipBench& bench = *chip;
  StatsReport report(plan.show.name(), plan.level, plan.k);
  files.run([&] { render_frames(plan, bench, files, report); }, bench.sound(),
            [&] { return report.text(); });
  if (plan.json) print(report.text());
  else if (report.frames() > 1) print(table_total(report));
  const bool differs = report_locksteps(plan, options.assignments, bench, report.frames());
  const bool whole = report.frames() == plan.frames;
  tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  return differs ? ExitDifference : whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
