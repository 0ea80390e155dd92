// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/command_bench.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sc/camera_unit.h"
#include "sc/decision_datapath.h"
#include "sc/interval_fifo.h"
#include "sc/navigator.h"
#include "sc/pixel_output.h"
#include "sc/pwm_sound.h"
#include "sc/ray_stepper.h"
#include "sc/scene.h"
#include "sc/sequencer.h"
#include "sc/stacks.h"
#include "sc/subdivider.h"
#include "sc/vga_timing.h"
#include "tb/console.h"
#include "tb/errors.h"
#include "tb/nearest.h"
#include "tb/signal_bench.h"
#include "tb/unit_bench.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

template <class Unit>
std::unique_ptr<sc_core::sc_module> make() {
  if constexpr (std::is_constructible_v<Unit, const char*, knobs>)
    return std::make_unique<Unit>("unit", knobs{});
  else return std::make_unique<Unit>("unit");
}

struct UnitRow {
  const char* name;
  std::unique_ptr<sc_core::sc_module> (*make)();
};
constexpr UnitRow unit_rows[] = {
    {"vga_timing", make<vga_timing>},
    {"sequencer", make<sequencer>},
    {"camera_unit", make<camera_unit>},
    {"ray_stepper", make<ray_stepper>},
    {"subdivider", make<subdivider>},
    {"stacks", make<stacks>},
    {"decision_datapath", make<decision_datapath>},
    {"scene", make<scene>},
    {"navigator", make<navigator>},
    {"interval_fifo", make<interval_fifo>},
    {"pixel_output", make<pixel_output>},
    {"pwm_sound", make<pwm_sound>},
};

// The seven parts of the demo (contract 17.7): name and a frame in the thick of it.
struct PartRow {
  const char* name;
  int first_frame;
};
constexpr PartRow part_rows[] = {
    {"pillars", 1000}, {"ray pattern", 2500}, {"tunnel", 5000},          {"heights, open", 7200},
    {"twisted", 8960}, {"portals", 11000},    {"tunnel, narrow", 12500},
};

benchmark::internal::Benchmark* set_up(benchmark::internal::Benchmark* b, int repeats) {
  return b->Iterations(1)->Repetitions(repeats)->UseRealTime()->Unit(benchmark::kMillisecond);
}

void register_signal(const BenchOptions& options) {
  auto bench = std::make_shared<SignalBench>(SignalBench::Options{});
  for (const auto& part : part_rows)
    set_up(benchmark::RegisterBenchmark(
               (std::string("signal: ") + part.name).c_str(),
               [bench, part, frames = options.frames](benchmark::State& state) {
                 const auto before = bench->clocks();
                 for (auto _ : state) {
                   bench->seek(part.first_frame);
                   for (int f = 0; f < frames; ++f) bench->render();
                 }
                 state.counters["clocks"] = benchmark::Counter(
                     static_cast<double>(bench->clocks() - before), benchmark::Counter::kIsRate);
               }),
           options.repeats);
}

void register_unit(const UnitRow& row, int repeats) {
  constexpr int Edges = 500'000;
  std::shared_ptr<sc_core::sc_module> unit = row.make();
  auto bench = std::make_shared<UnitBench>(*unit);
  bench->stir(1);
  set_up(benchmark::RegisterBenchmark((std::string("unit: ") + row.name).c_str(),
                                      [unit, bench](benchmark::State& state) {
                                        for (auto _ : state) bench->clock(Edges);
                                        state.counters["clocks"] =
                                            benchmark::Counter(Edges, benchmark::Counter::kIsRate);
                                      }),
         repeats);
}

// The yardstick: what SystemC itself reaches on this machine.
struct KernelUnit : sc_core::sc_module {
  static constexpr int Wires = 4;
  in_port<1> clk_i{"clk_i"};
  wire<32> out[Wires];
  const KernelUnit* from = nullptr;

  explicit KernelUnit(const sc_core::sc_module_name& name) : sc_module(name) {
    SC_HAS_PROCESS(KernelUnit);
    SC_METHOD(seq);
    sensitive << clk_i.pos();
    dont_initialize();
  }
  void seq() {
    for (int i = 0; i < Wires; ++i) out[i].write(from->out[i].read() + 2 * i + 1);
  }
};

void register_kernel(int repeats) {
  constexpr int Units = 8, Edges = 2'000'000;
  auto clk = std::make_shared<sc_core::sc_clock>("clk", sc_core::sc_time(1, sc_core::SC_NS));
  auto units = std::make_shared<std::vector<std::unique_ptr<KernelUnit>>>();
  for (int i = 0; i < Units; ++i) {
    units->push_back(std::make_unique<KernelUnit>(("unit" + std::to_string(i)).c_str()));
    units->back()->clk_i(*clk);
  }
  for (int i = 0; i < Units; ++i) (*units)[i]->from = (*units)[(i + 1) % Units].get();
  set_up(benchmark::RegisterBenchmark(
             "kernel: 8 modules 32 signals",
             [clk, units](benchmark::State& state) {
               for (auto _ : state) sc_core::sc_start(sc_core::sc_time(Edges, sc_core::SC_NS));
               state.counters["clocks"] = benchmark::Counter(Edges, benchmark::Counter::kIsRate);
             }),
         repeats);
}

// Runs what `prepare` registers in a process of its own, as SystemC elaborates once, and returns
// Google Benchmark's rows.
Json run_apart(const std::function<void()>& prepare) {
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // do not outlive the program
    close(ends[0]);
    prepare();
    std::ostringstream out;
    benchmark::JSONReporter reporter;
    reporter.SetOutputStream(&out);
    reporter.SetErrorStream(&out);
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const std::string text = out.str();
    for (std::size_t done = 0; done < text.size();) {
      const auto n = write(ends[1], text.data() + done, text.size() - done);
      if (n <= 0) _exit(1);
      done += static_cast<std::size_t>(n);
    }
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part;
  for (ssize_t n; (n = read(ends[0], part.data(), part.size())) > 0;) text.append(part.data(), n);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) throw std::runtime_error("a benchmark died");
  return Json::parse(text).at("benchmarks");
}

/// Name and clocks a second of the median of each benchmark.
void collect(const Json& rows, bool json, Json& all) {
  for (const auto& row : rows) {
    if (row.value("run_type", "") == "aggregate" && row.value("aggregate_name", "") != "median")
      continue;
    const bool single = row.value("repetitions", 1) == 1;
    if (row.value("run_type", "") != "aggregate" && !single) continue;
    const std::string name = row.at("run_name").get<std::string>();
    const std::string label = name.substr(0, name.find('/'));
    const double rate = row.at("clocks").get<double>();
    all.push_back({{"name", label}, {"clocks_per_second", rate}});
    if (json) continue;
    print(fmt::format("{:<28} {:8.2f} M clocks/s\n", label, rate / 1e6));
  }
}

}  // namespace

int command_bench(const BenchOptions& options) {
  std::vector<std::string> known;
  for (const auto& row : unit_rows) known.push_back(row.name);
  for (const auto& name : options.units)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw unknown_name("unit", name, known);

  Json all = Json::array();
  if (options.units.empty()) {
    collect(run_apart([&] { register_kernel(options.repeats); }), options.json, all);
    collect(run_apart([&] { register_signal(options); }), options.json, all);
  }
  for (const auto& row : unit_rows)
    if (options.units.empty() ||
        std::find(options.units.begin(), options.units.end(), row.name) != options.units.end())
      collect(run_apart([&] { register_unit(row, options.repeats); }), options.json, all);
  if (options.json) {
    Json report{{"schema", "racebeam-bench"},
                {"version", 1},
                {"repeats", options.repeats},
                {"medians", all}};
    if (options.units.empty()) report["frames"] = options.frames;
    print(report.dump(2) + "\n");
  }
  return ExitGood;
}

}  // namespace racebeam
