// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/window_writer.h"

#include "tb/console.h"
#include "tb/counted.h"
#include "tb/errors.h"
#include "tb/trace/trace_files.h"

namespace racebeam {

namespace {

constexpr std::int64_t OverviewLines = 100;  ///< more are an overview, unless --scope says more

}  // namespace

int WindowWriter::write(TraceRun& run, const TraceWindow& window) const {
  const Raster& raster = run.raster();
  const std::int64_t first = window.from.ordinal(raster), last = window.to.ordinal(raster);
  const bool overview =
      selection.scopes.empty() && last - first >= OverviewLines * raster.line_clocks();
  VcdWriter vcd;
  SignalTrace trace(
      run.bench(), raster, run.bench().period_ps(), selection, overview,
      [&](int frame) { return show.part(frame); }, vcd);
  TraceFiles files(output, picture, "racebeam: " + show.name(), vcd);

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
  if (end == first) {
    tell("stopped before the window; nothing is written");
    return ExitInterrupted;
  }
  const auto time = [&](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock * run.bench().period_ps());
  };
  GtkwWindow seen{time(first), time(end), time(1), {}};
  if (window.mark) seen.marker = time(window.mark->ordinal(raster));
  files.commit(seen);
  const bool whole = end > last;
  tell((whole ? "wrote " : "stopped early; kept ") + files.names() + ": " +
       counted(vcd.names().size(), "signal") + ", " + counted(end - first, "clock"));
  if (overview && whole)
    tell("a long window has ports and wires only; --scope '*' has all signals");
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
