// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_tt.h"

#include <fmt/format.h>

#include <optional>

#include "tb/base/console.h"
#include "tb/base/interrupt.h"
#include "tb/trace/condition.h"
#include "tb/trace/tile_run.h"
#include "tb/trace/window_writer.h"
#include "tb/tt/tt_plugin.h"
#include "tb/tt/tt_remarks.h"
#include "tb/wave/clocked_waves.h"

namespace racebeam {

namespace {

void refuse_scene_options(const TraceOptions& options) {
  refuse_with_tt(!options.scene.empty(), "the scene, or --tt");
  refuse_with_tt(!options.assignments.empty(), "--set, or --tt");
  refuse_with_tt(!options.units.empty(), "--use, or --tt");
  refuse_with_tt(!options.text().empty(), "--shake and --stall, or --tt");
  refuse_with_tt(!options.delays.empty(), "--delays, or --tt");
  refuse_with_tt(options.transactions(), "--level tlm, or --tt");
  refuse_with_tt(!options.around.empty(),
                 "--around, which looks into the model; --when looks at the chip's signals");
  refuse_with_tt(options.record > 0, "--record, which watches the model, or --tt");
}

/// The first clock of `where` in which the condition holds. Nothing: the user wants to stop.
std::optional<TracePoint> find(const TraceOptions& options, const TraceWindow& where,
                               TileRun& run) {
  const TraceAxis& raster = run.raster();
  std::int64_t clock = where.from.ordinal(raster);
  const std::int64_t last = where.to.ordinal(raster);
  Condition condition(options.when, run.signals(true), raster);
  if (!run.go_to(clock)) return {};
  std::optional<TracePoint> found;
  run.each_clock([&](std::int64_t now) {
    if (!found && condition.holds(now)) found = point_at(now, raster);
  });
  while (!found && clock <= last) {
    clock = std::min<std::int64_t>(clock + raster.line_clocks(), last + 1);
    if (!run.go_to(clock)) return {};
  }
  if (!found) throw options.nothing_found(where, raster);
  tell(fmt::format("--when: frame {}, line {}, clock {}", found->frame, found->line, found->clock));
  return found;
}

}  // namespace

int trace_tt(const TraceOptions& options) {
  refuse_scene_options(options);
  const TtInputs inputs = tt_inputs(options);
  catch_interrupts();
  const TtProject project = read_tt_project(options.project, options.reading);
  TtRun chip(project, tt_plugin(project, options.reading.trust, true), inputs);
  for (const std::string& remark : assumptions(project, chip.found())) tell(remark);
  TileRun run(chip);
  const TraceAxis& raster = run.raster();
  const TraceWindowReader reader(MostTtFrames, raster);
  reader.check(options.from, options.to);
  options.check(raster);
  const WindowWriter writer{project.top, {}, options.output, options.picture, options.selection()};
  writer.check(run);
  TraceWindow window{};
  if (options.when.empty()) {
    window = options.said(reader);
  } else {
    const std::optional<TracePoint> found = find(options, options.searched(reader), run);
    if (!found) {
      tell("stopped while searching; nothing is written");
      return ExitInterrupted;
    }
    window = options.around_point(*found, reader, raster);
    run.restart();
  }
  if (!options.picture.empty())
    check_picture_clocks(window.to.ordinal(raster) - window.from.ordinal(raster) + 1);
  return writer.write(run, window);
}

}  // namespace racebeam
