// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <memory>

#include "tb/bench/signal_bench.h"
#include "tb/show/show.h"
#include "tb/speed/chip_rows.h"
#include "tb/speed/own_process.h"
#include "tb/trace/condition.h"
#include "tb/trace/flight_recorder.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_run.h"

namespace racebeam {

namespace {

constexpr int BusyFrame = 7223;  // of the demo: the tracer has no rest
constexpr const char* Nowhere = "/dev/null";
const TraceAxis raster;

/// A run of some frames to their end.
using Run = std::function<void(TraceRun&, std::int64_t end)>;

void traced(TraceRun& run, std::int64_t end, bool overview) {
  const Show show;
  VcdWriter vcd;
  if (!overview) run.bench().watch_registers();
  SignalTrace trace(
      chip_signals(run.bench()), raster, run.bench().period_ps(), {}, overview,
      [&](int frame) { return show.part(frame); }, vcd);
  OutputFile file(Nowhere);
  vcd.stream(file, "bench");
  run.each_clock([&](std::int64_t clock) { trace.sample(point_at(clock, raster)); });
  run.go_to(end);
  run.each_clock({});
}

void asked(TraceRun& run, std::int64_t end) {
  run.bench().watch_registers();
  Condition condition("u_subdivider.sd_q == 7 && line == 0", chip_signals(run.bench()), raster);
  bool held = false;
  run.each_clock([&](std::int64_t clock) { held = held || condition.holds(clock); });
  run.go_to(end);
  run.each_clock({});
}

void recorded(TraceRun& run, std::int64_t end) {
  FlightRecorder recorder(10 * raster.line_clocks(), [](const FlightEvent&) { return 0; });
  while (run.clock() < end) {
    recorder.pass(run.clock());
    run.go_to(run.clock() + raster.line_clocks());
  }
}

}  // namespace

void register_traces(const Effort& effort) {
  const auto bench = std::make_shared<SignalBench>(SignalBench::Options{});
  const auto add = [&](const char* name, const Run& go) {
    set_up(benchmark::RegisterBenchmark(
               name,
               [bench, go, frames = effort.frames](benchmark::State& state) {
                 const auto before = bench->clocks();
                 for (auto _ : state) {
                   TraceRun run(*bench, raster, BusyFrame);
                   go(run, run.clock() + static_cast<std::int64_t>(frames) * raster.frame_clocks());
                 }
                 state.counters["clocks"] = benchmark::Counter(
                     static_cast<double>(bench->clocks() - before), benchmark::Counter::kIsRate);
               }),
           effort.repeats);
  };
  add("trace: none", [](auto& run, auto end) { run.go_to(end); });
  add("trace: flight recorder", recorded);
  add("trace: overview", [](auto& run, auto end) { traced(run, end, true); });
  add("trace: all signals", [](auto& run, auto end) { traced(run, end, false); });
  add("trace: a condition", asked);
}

}  // namespace racebeam
