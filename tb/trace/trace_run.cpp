// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_run.h"

#include <algorithm>
#include <utility>

#include "tb/base/interrupt.h"

namespace racebeam {

TraceRun::TraceRun(WiredBench& bench, const TraceAxis& raster, int frame)
    : bench_(bench), raster_(raster), clock_(TracePoint{frame, FirstLine, 0}.ordinal(raster)) {
  bench_.seek(frame);
  bench_.settle();
  epoch_ = 0;
  epoch_ = clock_ - kernel_clock();
}

std::int64_t TraceRun::kernel_clock() const {
  return epoch_ + static_cast<std::int64_t>(sc_core::sc_time_stamp().value()) / bench_.period_ps();
}

std::vector<ChipSignal> TraceRun::signals(bool registers) {
  if (registers) bench_.watch_registers();
  return chip_signals(bench_);
}

bool TraceRun::go_to(std::int64_t clock) {
  const int line = raster_.line_clocks();
  while (clock_ < clock) {
    if (interrupted()) return false;
    const std::int64_t step = std::min(clock - clock_, line - clock_ % line);
    bench_.advance(static_cast<int>(step));
    clock_ += step;
    line_done();
  }
  return !interrupted();
}

void TraceRun::each_clock(std::function<void(std::int64_t)> look) {
  if (!look) return bench_.each_clock({});
  bench_.each_clock([look = std::move(look), clock = clock_]() mutable { look(clock++); });
}

}  // namespace racebeam
