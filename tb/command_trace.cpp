// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/command_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "tb/console.h"
#include "tb/errors.h"
#include "tb/interrupt.h"
#include "tb/nearest.h"
#include "tb/open_show.h"
#include "tb/set_knob.h"
#include "tb/trace/clocked_waves.h"
#include "tb/trace/diff_report.h"
#include "tb/trace/draw_waveform.h"
#include "tb/trace/event_watch.h"
#include "tb/trace/trace_files.h"
#include "tb/trace/trigger.h"
#include "tb/trace/wave_file.h"
#include "tb/trace/window_writer.h"
#include "tb/use_option.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* Mismatch = "mismatch";
constexpr int MostFramesAround = 10;

void check_range(const char* option, long long value, long long min, long long max) {
  if (value < min || value > max)
    throw UsageError(fmt::format("{} {} is out of range; {}..{}", option, value, min, max));
}

TraceSelection selection_of(const TraceOptions& options) {
  check_range("--depth", options.depth, 0, 9);
  return {options.scopes, static_cast<int>(options.depth)};
}

/// Something is to be found first: the window follows from it.
bool searches(const TraceOptions& options) {
  return !options.around.empty() || !options.when.empty() || options.record > 0;
}

void check_search(const TraceOptions& options) {
  if (!options.around.empty() + !options.when.empty() > 1)
    throw UsageError("--around and --when are two things to look for; give one");
  if (options.record > 0 && !options.around.empty())
    throw UsageError("--record watches for mismatches by itself; leave out --around, or --record");
  std::vector<std::string> triggers = trigger_names();
  triggers.push_back(Mismatch);
  if (!options.around.empty() &&
      std::find(triggers.begin(), triggers.end(), options.around) == triggers.end())
    throw unknown_name("trigger", options.around, triggers);
  if ((options.pre || options.post) && !searches(options))
    throw UsageError("--pre and --post are clocks around what --around, --when or --record finds");
  if (options.pre && options.record > 0)
    throw UsageError("--record says how many lines before the event are kept; leave out --pre");
  check_range("--lines", options.lines, 0, FrameLines - 1);
  check_range("--record", options.record, 0, MostFramesAround * FrameLines);
}

void check_usage(const TraceOptions& options, const Raster& raster) {
  if (options.output.empty() && options.picture.empty())
    throw UsageError("-o FILE.vcd or FILE.fst, or --picture FILE.svg, says where to write");
  if (!options.picture.empty()) check_picture_name(options.picture);
  if (!options.output.empty() && !is_waveform(options.output))
    throw UsageError(options.output + ": a waveform ends with .vcd or .fst");
  if (fs::path(options.output).extension() == ".fst") need_vcd2fst();
  check_search(options);
  if (!searches(options) && (options.from.empty() || options.to.empty()))
    throw UsageError(
        "the window is missing: say --from FRAME:LINE and --to FRAME:LINE, or --around "
        "first-starved, or --when 'u_subdivider.sd_q == 4'");
  for (const auto& [name, clocks] : {std::pair{"--pre", options.pre}, {"--post", options.post}})
    check_range(name, clocks.value_or(0), 0, MostFramesAround * raster.frame_clocks());
}

/// The part of the show that is searched: to the end of the frame unless --to says more.
TraceWindow searched(const TraceOptions& options, const TraceWindowReader& reader) {
  const std::string from = options.from.empty() ? fmt::format("0:{}", FirstLine) : options.from;
  return reader.window(from, options.to.empty()
                                 ? from.substr(0, from.find(':')) + fmt::format(":{}", LastLine)
                                 : options.to);
}

TraceWindow around(const TracePoint& point, const TraceOptions& options,
                   const TraceWindowReader& reader, const Raster& raster) {
  if (options.record > 0)
    return reader.around(point, options.record * raster.line_clocks(), options.post.value_or(0));
  if (options.pre || options.post)
    return reader.around(point, options.pre.value_or(0), options.post.value_or(0));
  return reader.around(point, options.lines);
}

UsageError nothing_found(const TraceOptions& options, const TraceWindow& where) {
  return UsageError(
      fmt::format("nothing of {} from {}:{} to {}:{}; search further with --from and --to",
                  options.around.empty() ? "--when '" + options.when + "'" : options.around,
                  where.from.frame, where.from.line, where.to.frame, where.to.line));
}

/// The window that the command line says, or that the cores alone can find.
TraceWindow window_of(const TraceOptions& options, const TraceWindowReader& reader,
                      const SignalBench::Options& setting, const Raster& raster) {
  if (options.around.empty()) return reader.window(options.from, options.to);
  const TraceWindow where = searched(options, reader);
  const std::optional<TracePoint> found =
      find_trigger(options.around, where, setting.k, raster, setting.program);
  if (!found) throw nothing_found(options, where);
  tell(fmt::format("{}: frame {}, line {}, clock {}", options.around, found->frame, found->line,
                   found->clock));
  return around(*found, options, reader, raster);
}

/// Runs the chip until something happens.
int watch(const TraceOptions& options, const TraceWindowReader& reader, SignalBench& bench,
          const Raster& raster, const WindowWriter& writer) {
  if (options.around == Mismatch && bench.locksteps().empty())
    throw UsageError("--around mismatch compares nothing; add --use UNIT=lockstep");
  const TraceWindow where = searched(options, reader);
  std::optional<Condition> condition;
  if (!options.when.empty()) condition.emplace(options.when, bench, raster);
  const long long lines = options.record > 0 ? options.record : options.lines + 1;
  TraceRun run(bench, raster, where.from);
  const EventWatch watch{
      condition ? &*condition : nullptr,
      std::max(lines * raster.line_clocks(), options.pre.value_or(0)),
      [&](const TracePoint& at) { return around(at, options, reader, raster); },
      [&](TraceRun& copy, const TraceWindow& window) { return writer.write(copy, window); }};
  if (const std::optional<int> code = watch.run(run, where.to.ordinal(raster))) return *code;
  if (!options.when.empty() && options.record == 0) throw nothing_found(options, where);
  tell(fmt::format("nothing happened from {}:{} to {}:{}; nothing is written", where.from.frame,
                   where.from.line, where.to.frame, where.to.line));
  return ExitGood;
}

int draw(const TraceOptions& options, const TraceSelection& selection) {
  if (!(options.from + options.to + options.output).empty() || searches(options) ||
      !options.assignments.empty() || !options.units.empty())
    throw UsageError(options.scene +
                     " is a waveform and drawn as it is; of the other options only --scope and "
                     "--depth mean something there");
  return draw_waveform(options.scene, options.picture, selection);
}

}  // namespace

int command_trace(const TraceOptions& options) {
  if (!options.diff.empty())
    return report_diff(options.diff.at(0), options.diff.at(1), options.shared);
  const TraceSelection selection = selection_of(options);
  if (is_waveform(options.scene)) return draw(options, selection);
  if (options.scene.empty())
    throw UsageError("scene is required, or --diff; `racebeam trace --help` shows what it takes");
  const Show show = open_show(options.scene);
  SignalBench::Options setting{show.standard_knobs()};
  for (const std::string& assignment : options.assignments) set_knob(setting.k, assignment);
  if (const std::string why = show.objection(setting.k); !why.empty()) throw UsageError(why);
  setting.program = show.program();
  const Raster raster(setting.k.clocks_per_pixel, setting.k.speed);
  check_usage(options, raster);

  const TraceWindowReader reader(show.frames(), raster);
  const bool runs = options.around == Mismatch || !options.when.empty() || options.record > 0;
  std::optional<TraceWindow> window;
  if (!runs) window = window_of(options, reader, setting, raster);
  if (window && !options.picture.empty())
    check_picture_clocks(window->to.ordinal(raster) - window->from.ordinal(raster) + 1);
  const UseOption use(setting.k, show.program(), true);
  for (const std::string& choice : options.units) use.use(setting.units, choice);
  SignalBench bench(setting);
  const WindowWriter writer{show, options.output, options.picture, selection};
  catch_interrupts();
  if (!window) return watch(options, reader, bench, raster, writer);
  TraceRun run(bench, raster, window->from);
  return writer.write(run, *window);
}

}  // namespace racebeam
