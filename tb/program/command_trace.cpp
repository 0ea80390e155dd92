// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/bench/benches.h"
#include "tb/program/common_options.h"
#include "tb/show/open_show.h"
#include "tb/trace/beam_transaction_bench.h"
#include "tb/trace/beam_trigger.h"
#include "tb/trace/event_watch.h"
#include "tb/trace/trace_tt.h"
#include "tb/trace/window_writer.h"
#include "tb/wave/clocked_waves.h"
#include "tb/wave/diff_report.h"
#include "tb/wave/draw_waveform.h"

namespace racebeam {

namespace {

int compare(const TraceOptions& options) {
  if (options.needs_run() || !(options.scene + options.picture).empty())
    throw UsageError(
        "--diff compares two files that are there; of the other options only --shared, --scope and "
        "--depth mean something with it");
  return report_diff(options.diff.at(0), options.diff.at(1), options.shared, options.selection());
}

int draw(const TraceOptions& options) {
  if (options.needs_run())
    throw UsageError(options.scene +
                     " is a waveform and drawn as it is; of the other options only --scope and "
                     "--depth mean something there");
  return draw_waveform(options.scene, options.picture, options.selection());
}

/// The window that the command line says, or that the cores alone can find; none if the user stops
/// them.
std::optional<TraceWindow> window_of(const TraceOptions& options, const TraceWindowReader& reader,
                                     const Run& run, const TraceAxis& raster) {
  if (!options.searches()) return options.said(reader);
  expect_rooms(run.show, "--around");
  const TraceWindow where = options.searched(reader);
  const std::int64_t begin = TracePoint{where.from.frame, FirstLine, 0}.ordinal(raster);
  const int line = raster.line_clocks();
  Progress progress((where.to.ordinal(raster) - begin) / line + 1, "lines");
  const std::optional<TracePoint> found = find_trigger(
      options.around, where, run.k, raster, run.show.program(), [&](std::int64_t clocks) {
        progress.draw(clocks / line, static_cast<std::uint64_t>(clocks));
        return !interrupted();
      });
  progress.clear();
  if (interrupted()) return std::nullopt;
  if (!found) throw options.nothing_found(where, raster);
  tell(fmt::format("{}: frame {}, line {}, clock {}", options.around, found->frame, found->line,
                   found->clock));
  return options.around_point(*found, reader, raster);
}

/// Runs the chip until something happens.
int watch(const TraceOptions& options, const TraceWindowReader& reader, WiredBench& bench,
          const TraceAxis& raster, const WindowWriter& writer) {
  const TraceWindow where = options.searched(reader);
  const std::int64_t first = where.from.ordinal(raster), before = options.clocks_before(raster);
  if (!options.picture.empty()) check_picture_clocks(options.most_clocks(raster));
  TraceRun run(bench, raster, point_at(std::max<std::int64_t>(first - before, 0), raster).frame);
  writer.check(run);
  std::optional<Condition> condition;
  if (!options.when.empty()) {
    bench.watch_registers();
    condition.emplace(options.when, chip_signals(bench), raster);
  }
  const EventWatch watch{
      condition ? &*condition : nullptr, before,
      [&](const TracePoint& at) { return options.around_point(at, reader, raster); },
      [&](TraceRun& copy, const TraceWindow& window) { return writer.write(copy, window); }};
  if (const std::optional<int> code = watch.run(run, first, where.to.ordinal(raster))) return *code;
  if (!options.when.empty() && options.record == 0) throw options.nothing_found(where, raster);
  tell(fmt::format("nothing happened from {} to {}; nothing is written",
                   point_option(where.from, raster), point_option(where.to, raster)));
  return ExitGood;
}

WiredBench::Setting setting_of(const Run& run) {
  return {run.show.engine(), run.k, run.show.tables(), run.show.frames(), run.units};
}

/// Whether some unit is compared.
bool compares(const unit_choices& units) {
  return std::any_of(units.by_unit.begin(), units.by_unit.end(),
                     [](const auto& one) { return one.second.lockstep; });
}

}  // namespace

int command_trace(const TraceOptions& options) {
  if (!options.diff.empty()) return compare(options);
  if (options.shared)
    throw UsageError("--shared is for the two files of --diff; leave it out, or add --diff");
  if (!options.project.empty()) return trace_tt(options);
  refuse_tt_options(options);
  if (is_waveform(options.scene)) return draw(options);
  if (options.scene.empty())
    throw UsageError(
        "scene is required, or --tt, or --diff; `racebeam trace --help` shows what it takes");
  Run run = open_run(options);
  const auto pixels = bench_of(run.show.engine()).pixels;
  const TraceAxis raster(run.raster(), run.show.engine().races_beam);
  const TraceWindowReader reader(run.show.frames(), raster,
                                 [&](int picture) { return pixels(setting_of(run), picture); });
  reader.check(options.from, options.to);
  options.check(run.raster());

  const WindowWriter writer{run.show.name(), [&](int frame) { return run.show.part(frame); },
                            options.output, options.picture, options.selection()};
  catch_interrupts();
  std::optional<TraceWindow> window;
  if (!options.watches()) {
    window = window_of(options, reader, run, raster);
    if (!window) return ExitInterrupted;
  }
  if (window && !options.picture.empty())
    check_picture_clocks(window->to.ordinal(raster) - window->from.ordinal(raster) + 1);
  if (options.transactions() && !options.shake.empty())
    throw UsageError("--shake stalls wires of --level signal; leave out --level tlm, or --shake");
  if (options.transactions() && !options.delays.empty())
    throw UsageError(
        "--delays puts registers into wires of --level signal; leave out --level tlm, or --delays");
  if (options.transactions()) expect_rooms(run.show, "trace --level tlm");
  if (options.transactions())
    return writer.write_frames(
        [&](VcdWriter& vcd) {
          return std::make_unique<TransactionBench>(run.k, run.show.program(), raster,
                                                    writer.selection, writer.part, vcd);
        },
        raster, clock_period_ps(run.show.engine().video(run.k).clocks_per_pixel), *window);

  const auto delay_plan = delay_plan_of(run.show.engine(), options);
  use_units(run, options.units, true, options.shake.empty() && !delay_plan);
  leave_out_whole_chip(run.show.engine(), options, options.units, run.units);
  if (options.awaits_mismatch() && !compares(run.units))
    throw UsageError("--around mismatch compares nothing; add --use UNIT=lockstep");
  check_delays(run.show.engine(), options, options, options.units, run.units);
  const planned_stalls stalls(stall_plan_of(run.show.engine(), options));
  const planned_delays delays(delay_plan);
  WiredBench bench(setting_of(run));
  if (!window) return watch(options, reader, bench, raster, writer);
  TraceRun traced(bench, raster, window->from.frame);
  return writer.write(traced, *window);
}

namespace {

void add_options(const CommandOptions& command, TraceOptions& options) {
  command
      .add_option("scene", options.scene,
                  "demo, or a scene file; or a waveform FILE.vcd for --picture to draw")
      .type_name("SCENE");
  const auto text = [&](const char* name, std::string& to, const char* type, const char* help) {
    command.add_option(name, to, help).type_name(type).check(not_empty);
  };
  const auto list = [&](const char* name, std::vector<std::string>& to, const char* type,
                        const char* help) {
    command.add_option(name, to, help).type_name(type).repeatable();
  };
  text("-o,--output", options.output, "FILE",
       "FILE.vcd, or FILE.fst by vcd2fst; FILE.gtkw for GTKWave is written beside it, "
       "and never replaces one that GTKWave saved");
  command
      .add_option("--level", options.level,
                  "signal: units wired at 50.4 MHz; tlm: lines, intervals, rooms, restarts and "
                  "display writes as transactions, small and fast enough for many frames")
      .type_name("LEVEL")
      .check(not_empty)
      .capture_default_str();
  text("--picture", options.picture, "FILE.svg",
       "Draw the window, for documents; of at most 400 clocks and 100 signals");
  text("--from", options.from, "FRAME:LINE[:CLOCK]",
       "First clock; lines are -273..251; of an engine that does not race the beam PICTURE:CLOCK, "
       "or PICTURE:@X,Y, in which that pixel begins");
  text("--to", options.to, "FRAME:LINE[:CLOCK]", "Last clock; without CLOCK the line's last");
  text(
      "--around", options.around, "TRIGGER",
      "first-starved, first-restart, max-stack, or mismatch (of units in lockstep) instead: looked "
      "for from --from, 0, up to --to, the end of that frame");
  text("--when", options.when, "CONDITION",
       "The first clock in which it is true instead: 'u_subdivider.sd_q == 4 && line == 240'; "
       "looked for as --around is");
  const auto number = [&](const char* name, auto& to, const char* help) {
    return command.add_option(name, to, help).type_name("N").check(is_number(name, "0 or more"));
  };
  number("--pixels", options.pixels, "So many pixels from --from PICTURE:@X,Y on, instead of --to");
  number("--lines", options.lines, "Lines before and after the one of --around or --when")
      .default_str("1");
  number("--pre", options.pre, "Clocks before it instead of lines");
  number("--post", options.post, "Clocks after it instead of lines");
  number("--record", options.record,
         "Flight recorder: run from --from to --to, and write the last N lines only if something "
         "happens: --when, a mismatch in lockstep, a crash, Ctrl-C");
  list("--scope", options.scopes, "GLOB",
       "Only signals that match, or that such a scope holds: 'chip.u_subdivider', '*.i1_q'; "
       "repeatable; with --diff, only these are compared");
  number("--depth", options.depth, "Levels of the hierarchy, 1: the chip's own; 0: all")
      .capture_default_str();
  add_tt_options(command, options);
  add_run_options(command, options);
  add_shake_options(command, options);
  add_delay_options(command, options);
  list("--use", options.units, "UNIT=IMPLEMENTATION",
       "Put RTL in a unit's place, as in render; its own signals are shown too; repeatable");
  command.add_option("--diff", options.diff, "Instead of a scene: compare two files")
      .type_name("A.vcd B.vcd")
      .expected(2);
  command.add_flag("--shared", options.shared,
                   "With --diff: only the signals and the time that both files have");
}

}  // namespace

Command trace_row() {
  return make_command<TraceOptions>(
      "trace",
      "Write the chip's signals or transactions as a waveform or a picture, or compare two", "See",
      "trace demo --around first-restart --lines 2 -o restart.vcd", add_options, command_trace);
}

}  // namespace racebeam
