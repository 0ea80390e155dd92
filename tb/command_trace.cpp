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
#include "tb/nearest.h"
#include "tb/open_show.h"
#include "tb/output_file.h"
#include "tb/render_options.h"
#include "tb/set_knob.h"
#include "tb/trace/diff_report.h"
#include "tb/trace/gtkw_file.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/transaction_bench.h"
#include "tb/trace/trigger.h"
#include "tb/trace/wave_file.h"
#include "tb/use_option.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

void check_usage(const TraceOptions& options) {
  if (options.scene.empty())
    throw UsageError("scene is required, or --diff; `racebeam trace --help` shows what it takes");
  if (options.output.empty()) throw UsageError("-o FILE.vcd or FILE.fst says where to write");
  const std::string extension = fs::path(options.output).extension().string();
  if (extension != ".vcd" && extension != ".fst")
    throw UsageError(options.output + ": a waveform ends with .vcd or .fst");
  if (extension == ".fst") need_vcd2fst();
  if (options.around.empty() && (options.from.empty() || options.to.empty()))
    throw UsageError(
        "a whole frame is over a hundred megabytes, some megabytes with --level tlm: say --from "
        "FRAME:LINE and --to FRAME:LINE, or --around first-starved");
  if (options.level != LevelSignal && options.level != LevelTlm)
    throw unknown_name("level", options.level, {LevelTlm, LevelSignal});
  if (options.level == LevelTlm && !options.units.empty())
    throw UsageError(
        "--use puts RTL between the wires of --level signal; tlm has none: leave out --level tlm, "
        "or --use");
  if (options.lines < 0 || options.lines >= FrameLines)
    throw UsageError(
        fmt::format("--lines {} is out of range; 0..{}", options.lines, FrameLines - 1));
  if (options.depth < 0 || options.depth > 9)
    throw UsageError(fmt::format("--depth {} is out of range; 0..9", options.depth));
}

TraceWindow window_of(const TraceOptions& options, const Show& show, const knobs& k,
                      const Raster& raster) {
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

}  // namespace

int command_trace(const TraceOptions& options) {
  if (!options.diff.empty())
    return report_diff(options.diff.at(0), options.diff.at(1), options.shared);
  check_usage(options);
  const Show show = open_show(options.scene);
  SignalBench::Options setting{show.standard_knobs()};
  for (const std::string& assignment : options.assignments) set_knob(setting.k, assignment);
  if (const std::string why = show.objection(setting.k); !why.empty()) throw UsageError(why);
  setting.program = show.program();
  const Raster raster(setting.k.clocks_per_pixel, setting.k.speed);
  const TraceWindow window = window_of(options, show, setting.k, raster);
  const UseOption use(setting.k, show.program(), true);
  for (const std::string& choice : options.units) use.use(setting.units, choice);

  const int period = clock_period_ps(setting.k.clocks_per_pixel);
  VcdWriter vcd;
  const TraceSelection selection{options.scopes, static_cast<int>(options.depth)};
  const auto part = [&](int frame) { return show.part(frame); };
  catch_interrupts();
  WaveFile file(options.output);
  vcd.stream(file.vcd(), "racebeam: " + show.name());
  std::int64_t clocks;
  if (options.level == LevelTlm) {
    TransactionTrace trace(raster, period, selection, part, vcd);
    clocks = TransactionBench(setting.k, setting.program, raster, trace).run(window, interrupted);
  } else {
    SignalBench bench(setting);
    SignalTrace trace(bench, raster, period, selection, part, vcd);
    clocks = write_window(bench, trace, window, raster);
  }
  const std::int64_t end = window.from.ordinal(raster) + clocks;
  vcd.finish(static_cast<std::uint64_t>(end) * static_cast<std::uint64_t>(period));
  file.commit();
  write_text(gtkw_path(options.output), gtkw_text(options.output, vcd));
  const bool whole = end > window.to.ordinal(raster);
  tell(fmt::format("{} {} and {}: {}, {}", whole ? "wrote" : "stopped early; kept", options.output,
                   gtkw_path(options.output), counted(vcd.names().size(), "signal"),
                   counted(clocks, "clock")));
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
