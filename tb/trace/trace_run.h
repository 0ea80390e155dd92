// TraceRun: the chip on a SignalBench, moved by the clocks of the show.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "tb/signal_bench.h"
#include "tb/trace/trace_window.h"

namespace racebeam {

class TraceRun {
 public:
  /// Stands in the first clock of `frame`; nothing is simulated yet.
  TraceRun(SignalBench& bench, const Raster& raster, int frame);

  SignalBench& bench() const { return bench_; }
  const Raster& raster() const { return raster_; }
  /// Ordinal of the clock it stands in.
  std::int64_t clock() const { return clock_; }
  /// Ordinal of the clock that the kernel is in: during go_to() it runs ahead of clock().
  std::int64_t kernel_clock() const;

  /// Simulates up to that clock. False: the user wants to stop, and it stands at the end of a line.
  bool go_to(std::int64_t clock);
  /// Calls `look` with the ordinal of every clock from here on, its wires settled; an empty one
  /// ends that.
  void each_clock(std::function<void(std::int64_t)> look);
  /// Calls `look` after every line that go_to() passes, and at its end, with the clock() there; an
  /// empty one ends that.
  void each_line(std::function<void(std::int64_t)> look) { each_line_ = std::move(look); }
  /// Lets `look` see the clock in which the run stands.
  void settle() { bench_.settle(); }

 private:
  SignalBench& bench_;
  const Raster& raster_;
  std::int64_t clock_;
  std::function<void(std::int64_t)> each_line_;
  std::int64_t epoch_;  // of the kernel's time, in clocks: ordinal of its time 0
};

}  // namespace racebeam
