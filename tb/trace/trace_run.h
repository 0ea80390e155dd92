// TraceRun: the chip on a WiredBench, moved by the clocks of the show.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "tb/bench/wired_bench.h"
#include "tb/trace/clocked_run.h"
#include "tb/trace/trace_window.h"

namespace racebeam {

class TraceRun : public ClockedRun {
 public:
  /// Stands in the first clock of `frame`; nothing is simulated yet.
  TraceRun(WiredBench& bench, const TraceAxis& raster, int frame);

  WiredBench& bench() const { return bench_; }
  const TraceAxis& raster() const override { return raster_; }
  int period_ps() const override { return bench_.period_ps(); }
  std::vector<ChipSignal> signals(bool registers) override;
  const char* left_out() const override { return "no registers, clock, rays or geometry of rooms"; }
  /// Ordinal of the clock it stands in.
  std::int64_t clock() const override { return clock_; }
  /// Ordinal of the clock that the kernel is in: during go_to() it runs ahead of clock().
  std::int64_t kernel_clock() const;

  bool go_to(std::int64_t clock) override;
  void each_clock(std::function<void(std::int64_t)> look) override;
  void settle() override { bench_.settle(); }

 private:
  WiredBench& bench_;
  const TraceAxis& raster_;
  std::int64_t clock_;
  std::int64_t epoch_;  // of the kernel's time, in clocks: ordinal of its time 0
};

}  // namespace racebeam
