// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/command_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "tb/console.h"
#include "tb/counted.h"
#include "tb/errors.h"
#include "tb/interrupt.h"
#include "tb/open_show.h"
#include "tb/set_knob.h"
#include "tb/trace/clocked_waves.h"
#include "tb/trace/diff_report.h"
#include "tb/trace/draw_waveform.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_files.h"
#include "tb/trace/trigger.h"
#include "tb/trace/wave_file.h"
#include "tb/use_option.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

TraceSelection selection_of(const TraceOptions& options) {
  if (options.depth < 0 || options.depth > 9)
    throw UsageError(fmt::format("--depth {} is out of range; 0..9", options.depth));
  return {options.scopes, static_cast<int>(options.depth)};
}

void check_usage(const TraceOptions& options) {
  if (options.scene.empty())
    throw UsageError("scene is required, or --diff; `racebeam trace --help` shows what it takes");
  if (options.output.empty() && options.picture.empty())
    throw UsageError("-o FILE.vcd or FILE.fst, or --picture FILE.svg, says where to write");
  if (!options.picture.empty()) check_picture_name(options.picture);
  if (!options.output.empty() && !is_waveform(options.output))
    throw UsageError(options.output + ": a waveform ends with .vcd or .fst");
  if (fs::path(options.output).extension() == ".fst") need_vcd2fst();
  if (options.around.empty() && (options.from.empty() || options.to.empty()))
    throw UsageError(
        "a whole frame is over a hundred megabytes: say --from FRAME:LINE and --to FRAME:LINE, or "
        "--around first-starved");
  if (options.lines < 0 || options.lines >= FrameLines)
    throw UsageError(
        fmt::format("--lines {} is out of range; 0..{}", options.lines, FrameLines - 1));
}

// `marked`: what --around has found.
TraceWindow window_of(const TraceOptions& options, const Show& show, const knobs& k,
                      const Raster& raster, std::optional<TracePoint>& marked) {
  const TraceWindowReader reader(show.frames(), raster);
  if (options.around.empty()) return reader.window(options.from, options.to);
  const std::string from = options.from.empty() ? "0:-273" : options.from;
  const std::string to = options.to.empty()
                             ? from.substr(0, from.find(':')) + fmt::format(":{}", LastLine)
                             : options.to;
  const TraceWindow searched = reader.window(from, to);
  const std::optional<TracePoint> found =
      find_trigger(options.around, searched, k, raster, show.program());
  if (!found)
    throw UsageError(fmt::format("nothing of {} from {} to {}; search further with --from and --to",
                                 options.around, from, to));
  marked = found;
  tell(fmt::format("{}: frame {}, line {}, clock {}", options.around, found->frame, found->line,
                   found->clock));
  return reader.around(*found, options.lines);
}

// Simulates up to the window, then clock by clock. The clocks written.
std::int64_t write_window(SignalBench& bench, SignalTrace& trace, const TraceWindow& window,
                          const Raster& raster) {
  const std::int64_t first = window.from.ordinal(raster), last = window.to.ordinal(raster);
  bench.seek(window.from.frame);
  bench.settle();
  if (const auto before = first % raster.frame_clocks()) bench.advance(static_cast<int>(before));
  std::int64_t clock = first;
  for (; clock <= last && !interrupted(); ++clock) {
    trace.sample(point_at(clock, raster));
    bench.advance(1);
  }
  return clock - first;
}

int draw(const TraceOptions& options, const TraceSelection& selection) {
  if (!(options.from + options.to + options.around + options.output).empty() ||
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
  check_usage(options);
  const Show show = open_show(options.scene);
  SignalBench::Options setting{show.standard_knobs()};
  for (const std::string& assignment : options.assignments) set_knob(setting.k, assignment);
  if (const std::string why = show.objection(setting.k); !why.empty()) throw UsageError(why);
  setting.program = show.program();
  const Raster raster(setting.k.clocks_per_pixel, setting.k.speed);
  std::optional<TracePoint> marked;
  const TraceWindow window = window_of(options, show, setting.k, raster, marked);
  if (!options.picture.empty())
    check_picture_clocks(window.to.ordinal(raster) - window.from.ordinal(raster) + 1);
  const UseOption use(setting.k, show.program(), true);
  for (const std::string& choice : options.units) use.use(setting.units, choice);

  SignalBench bench(setting);
  const int period = clock_period_ps(setting.k.clocks_per_pixel);
  VcdWriter vcd;
  SignalTrace trace(
      bench, raster, period, selection, [&](int frame) { return show.part(frame); }, vcd);
  catch_interrupts();
  TraceFiles files(options.output, options.picture, "racebeam: " + show.name(), vcd);
  const std::int64_t clocks = write_window(bench, trace, window, raster);
  const std::int64_t end = window.from.ordinal(raster) + clocks;
  const auto time = [&](std::int64_t clock) { return static_cast<std::uint64_t>(clock * period); };
  GtkwWindow seen{time(window.from.ordinal(raster)), time(end), time(1), {}};
  if (marked) seen.marker = time(marked->ordinal(raster));
  files.commit(seen);
  const bool whole = end > window.to.ordinal(raster);
  tell(fmt::format("{} {}: {}, {}", whole ? "wrote" : "stopped early; kept", files.names(),
                   counted(vcd.names().size(), "signal"), counted(clocks, "clock")));
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
