// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/window_writer.h"

#include "tb/console.h"
#include "tb/counted.h"
#include "tb/errors.h"
#include "tb/interrupt.h"
#include "tb/trace/transaction_bench.h"

namespace racebeam {

namespace {

constexpr std::int64_t OverviewLines = 100;  ///< more are an overview, unless --scope says more
constexpr int ShortTransaction = 32;         ///< clocks

}  // namespace

int WindowWriter::write(ClockedRun& run, const TraceWindow& window) const {
  const Raster& raster = run.raster();
  const std::int64_t first = window.from.ordinal(raster), last = window.to.ordinal(raster);
  const bool overview =
      selection.scopes.empty() && last - first >= OverviewLines * raster.line_clocks();
  VcdWriter vcd;
  SignalTrace trace(run.signals(!overview), raster, run.period_ps(), selection, overview, part,
                    vcd);
  TraceFiles files(output, picture, "racebeam: " + name, vcd);

  std::int64_t end = first;
  if (run.go_to(first)) {
    run.each_clock([&](std::int64_t clock) {
      trace.sample(point_at(clock, raster));
      end = clock + 1;
    });
    run.go_to(last);
    run.settle();
    run.each_clock({});
  }
  if (overview && end > last)
    tell(std::string("a long window is an overview: ") + run.left_out() +
         "; --scope '*' has all signals");
  return finish(files, vcd, {window, raster, run.period_ps(), end - first, 1});
}

void WindowWriter::check(ClockedRun& run) const {
  VcdWriter vcd;
  SignalTrace(run.signals(false), run.raster(), run.period_ps(), selection, false, part, vcd);
  TraceFiles(output, picture, "", vcd);
}

int WindowWriter::write_transactions(const knobs& k, const scene_program* program,
                                     const Raster& raster, const TraceWindow& window) const {
  const int period = clock_period_ps(k.clocks_per_pixel);
  VcdWriter vcd;
  TransactionTrace trace(raster, period, selection, part, vcd);
  TraceFiles files(output, picture, "racebeam: " + name, vcd);
  const std::int64_t clocks = TransactionBench(k, program, raster, trace).run(window, interrupted);
  return finish(files, vcd, {window, raster, period, clocks, ShortTransaction});
}

int WindowWriter::finish(TraceFiles& files, const VcdWriter& vcd, const Written& written) const {
  if (written.clocks == 0) {
    tell("stopped before the window; nothing is written");
    return ExitInterrupted;
  }
  const std::int64_t first = written.window.from.ordinal(written.raster);
  const std::int64_t end = first + written.clocks;
  const auto time = [&](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock * written.period_ps);
  };
  GtkwWindow seen{time(first), time(end), time(written.readable), {}};
  if (const auto& mark = written.window.mark) seen.marker = time(mark->ordinal(written.raster));
  files.commit(seen);
  const bool whole = end > written.window.to.ordinal(written.raster);
  tell((whole ? "wrote " : "stopped early; kept ") + files.names() + ": " +
       counted(vcd.names().size(), "signal") + ", " + counted(written.clocks, "clock"));
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
