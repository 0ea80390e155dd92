// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/engine_rows.h"

#include <functional>
#include <memory>

#include "tb/bench/benches.h"
#include "tb/scene/engines.h"
#include "tb/show/show.h"
#include "tb/speed/own_process.h"

namespace racebeam {

namespace {

constexpr int Edges = 2'000'000;     // at the level signal
constexpr double Seconds = 0.5;      // about, of pictures
constexpr double Guess = 1 / 200e6;  // seconds a clock

WiredBench::Setting setting_of(const Show& show) {
  return {show.engine(), show.standard_knobs(), show.tables(), show.frames()};
}

void run_clocks(WiredBench& bench) {
  for (int left = Edges; left > 0;) {
    const auto before = bench.clocks();
    bench.advance(left);
    left -= static_cast<int>(bench.clocks() - before);
  }
}

/// Whole pictures until they are worth measuring.
void run_pictures(ChipBench& bench) {
  const auto before = bench.clocks();
  do bench.render();
  while (double(bench.clocks() - before) * Guess < Seconds);
}

}  // namespace

std::vector<EngineLevel> engine_levels() {
  std::vector<EngineLevel> rows;
  for (const engine* built : engines())
    for (const char* level : built->levels) rows.push_back({*built, level});
  return rows;
}

void register_engine(const EngineLevel& row, int repeats) {
  const auto show = std::make_shared<Show>(Show::built_in(row.built));
  std::shared_ptr<ChipBench> bench;
  std::function<void()> run;
  if (row.level == "signal") {
    const auto wired = std::make_shared<WiredBench>(setting_of(*show), WiredBench::Watches{true});
    run = [wired] { run_clocks(*wired); };
    bench = wired;
  } else {
    bench = bench_of(row.built).make(row.level, setting_of(*show), {});
    run = [bench] { run_pictures(*bench); };
  }
  bench->seek(show->frames() / 2);
  set_up(benchmark::RegisterBenchmark(row.name().c_str(),
                                      [show, bench, run](benchmark::State& state) {
                                        const auto before = bench->clocks();
                                        for (auto _ : state) run();
                                        state.counters["clocks"] = benchmark::Counter(
                                            static_cast<double>(bench->clocks() - before),
                                            benchmark::Counter::kIsRate);
                                      }),
         repeats);
}

}  // namespace racebeam
