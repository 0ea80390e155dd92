// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/chip_rows.h"

#include <iterator>
#include <memory>
#include <set>

#include "sc/beam/engine.h"
#include "sc/beam/units.h"
#include "sc/swap/rtl_run.h"
#include "tb/base/project_folder.h"
#include "tb/base/spread_frames.h"
#include "tb/bench/signal_bench.h"
#include "tb/bench/tlm_bench.h"
#include "tb/speed/own_process.h"
#include "tb/tt/tt_chip.h"
#include "tb/tt/tt_project.h"
#include "tb/twin/beam_twins.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

// The seven parts of the demo (contract 17.7): name and a frame in the thick of it.
struct PartRow {
  const char* name;
  int first_frame;
};
constexpr PartRow part_rows[] = {
    {"pillars", 1000}, {"ray pattern", 2500}, {"tunnel", 5000},          {"heights, open", 7200},
    {"twisted", 8960}, {"portals", 11000},    {"tunnel, narrow", 12500},
};
constexpr int MixFrame = 5000;  // tunnel

void register_frames(const std::string& name, const std::shared_ptr<ChipBench>& bench, int first,
                     const Effort& effort) {
  set_up(benchmark::RegisterBenchmark(
             name.c_str(),
             [bench, first, frames = effort.frames](benchmark::State& state) {
               const auto before = bench->clocks();
               bench->seek(first);
               for (auto _ : state)
                 for (int f = 0; f < frames; ++f) bench->render();
               state.counters["clocks"] = benchmark::Counter(
                   static_cast<double>(bench->clocks() - before), benchmark::Counter::kIsRate);
             }),
         effort.repeats);
}

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

}  // namespace

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

void register_parts(const Effort& effort) {
  const auto bench = std::make_shared<SignalBench>(SignalBench::Options{});
  for (const auto& part : part_rows)
    register_frames(std::string("signal: ") + part.name, bench, part.first_frame, effort);
}

int part_count() { return static_cast<int>(std::size(part_rows)); }

void register_tlm_parts(const Effort& effort) {
  const auto bench = std::make_shared<TlmBench>(TlmBench::Options{});
  for (const auto& part : part_rows)
    register_frames(std::string("tlm: ") + part.name, bench, part.first_frame, effort);
  constexpr int Samples = 100;
  set_up(benchmark::RegisterBenchmark(
             "tlm: all over the demo",
             [bench](benchmark::State& state) {
               for (auto _ : state)
                 for (const int frame : spread_frames(DemoFrames, Samples)) {
                   state.PauseTiming();
                   bench->seek(frame);
                   state.ResumeTiming();
                   bench->render();
                 }
               state.counters["clocks"] = benchmark::Counter(
                   Samples * double(Raster().frame_clocks()), benchmark::Counter::kIsRate);
             }),
         effort.repeats);
}

void register_verilated(const std::string& name, int repeats, bool alone) {
  const TtProject project = read_tt_project(rtl_folder());
  const auto chip = std::make_shared<TtChip>(make_chip_plugin(project.top, project.sources),
                                             project.source_folder, TilePins{});
  chip->reset(1);
  const auto how = alone ? set_up_alone : set_up;
  how(benchmark::RegisterBenchmark(name.c_str(),
                                   [chip](benchmark::State& state) {
                                     const int clocks = Raster().frame_clocks();
                                     std::vector<PinChange> changes;
                                     for (auto _ : state) chip->run(clocks, changes);
                                     state.counters["clocks"] =
                                         benchmark::Counter(clocks, benchmark::Counter::kIsRate);
                                   }),
      repeats);
}

std::vector<ChipMix> chip_mixes() {
  const PluginMaker plugins = beam_plugins({});
  std::vector<ChipMix> mixes = {{"all models", {}}};
  ChipMix all_rtl{"all RTL", {}}, all_lockstep{"all in lockstep", {}};
  for (const std::string& unit : chip_units(false)) {
    const std::string plugin = plugins.own(unit);
    const unit_choice rtl{unit_choice::Rtl, false, plugin};
    const unit_choice lockstep{unit_choice::Model, true, plugin};
    mixes.push_back({unit + " RTL", {{{unit, rtl}}}});
    all_lockstep.units.by_unit[unit] = lockstep;
  }
  const UseOption use(beam_engine(), knobs(), nullptr);
  use.use(all_rtl.units, "all=rtl");
  use.join(all_rtl.units);
  mixes.push_back(all_rtl);
  mixes.push_back(all_lockstep);
  return mixes;
}

std::vector<ChipMix> neighbour_mixes() {
  const UseOption use(beam_engine(), knobs(), nullptr);
  const std::vector<std::string> units = chip_units(false);
  std::vector<ChipMix> mixes = {{"all models", {}}};
  for (auto one = units.begin(); one != units.end(); ++one)
    for (auto other = one + 1; other != units.end(); ++other) {
      ChipMix mix{*one + ", " + *other, {}};
      use.use(mix.units, *one + "=rtl," + *other + "=rtl");
      use.join(mix.units);
      if (!mix.units.of(*one).island.empty()) mixes.push_back(mix);
    }
  return mixes;
}

void register_mix(const ChipMix& mix, const Effort& effort) {
  const auto bench = std::make_shared<SignalBench>(
      SignalBench::Options{{}, false, false, false, nullptr, mix.units});
  std::set<std::string> plugins;  // an island is one
  for (const auto& named : mix.units.by_unit)
    plugins.insert(named.second.island.empty() ? named.second.plugin : named.second.island);
  set_up_alone(
      benchmark::RegisterBenchmark(
          ("mix: " + mix.name).c_str(),
          [bench, models = plugins.size(), frames = effort.frames](benchmark::State& state) {
            bench->seek(MixFrame);
            const auto before = bench->clocks(), evaluations = rtl_evaluations();
            for (auto _ : state)
              for (int f = 0; f < frames; ++f) bench->render();
            const auto clocks = static_cast<double>(bench->clocks() - before);
            state.counters["clocks"] = benchmark::Counter(clocks, benchmark::Counter::kIsRate);
            if (models > 0)
              state.counters["evaluations"] = static_cast<double>(rtl_evaluations() - evaluations) /
                                              clocks / static_cast<double>(models);
          }),
      effort.repeats);
}

}  // namespace racebeam
