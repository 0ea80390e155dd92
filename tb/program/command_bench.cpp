// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "sc/beam/units.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/base/progress.h"
#include "tb/base/project_folder.h"
#include "tb/program/common_options.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/speed/block_rows.h"
#include "tb/speed/chip_rows.h"
#include "tb/speed/engine_rows.h"
#include "tb/speed/host_rows.h"
#include "tb/speed/mix_rounds.h"
#include "tb/speed/own_process.h"
#include "tb/speed/sphere_rows.h"
#include "tb/speed/store_rows.h"
#include "tb/speed/sweep_rows.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

void register_unit(const unit_row& row, int repeats) {
  constexpr int Edges = 500'000;
  const bool of_file = row.shows == unit_row::SceneFile;
  const auto show =
      std::make_shared<Show>(open_show(of_file ? project_folder() + "/scenes/demo.toml" : "demo"));
  std::shared_ptr<sc_core::sc_module> unit =
      row.make("unit", show->standard_knobs(), show->program());
  auto bench = std::make_shared<UnitBench>(*unit);
  bench->stir(1);
  set_up(benchmark::RegisterBenchmark((std::string("unit: ") + row.name).c_str(),
                                      [show, unit, bench](benchmark::State& state) {
                                        for (auto _ : state) bench->clock(Edges);
                                        state.counters["clocks"] =
                                            benchmark::Counter(Edges, benchmark::Counter::kIsRate);
                                      }),
         repeats);
}

/// Clocks a second of a row; 0 if there is none of the name.
double rate_of(const Json& all, const std::string& name) {
  for (const auto& row : all)
    if (row.at("name") == name) return row.at("clocks_per_second");
  return 0;
}

/// Clocks a second that a row is compared with; 0: with none.
using Base = std::function<double(const std::string& name, double rate)>;

/// Compares with the first row that it is asked for.
Base beside_first() {
  return [first = std::make_shared<double>(0)](const std::string&, double rate) {
    if (*first == 0) *first = rate;
    return *first;
  };
}

/// Name and clocks a second, or seconds, of the median of each benchmark. `rows`: their JSON. With
/// a base the ratio to it too.
void collect(const Json& rows, bool json, Json& all, const Base& base = {}) {
  for (const auto& row : rows) {
    if (row.value("run_type", "") == "aggregate" && row.value("aggregate_name", "") != "median")
      continue;
    const bool single = row.value("repetitions", 1) == 1;
    if (row.value("run_type", "") != "aggregate" && !single) continue;
    const std::string name = row.at("run_name").get<std::string>();
    const std::string label = name.substr(0, name.find('/'));
    if (row.contains("seconds")) {
      const double seconds = row.at("seconds").get<double>();
      all.push_back({{"name", label}, {"seconds", seconds}});
      if (!json) print(fmt::format("{:<34} {:8.2f} ms\n", label, seconds * 1e3));
      continue;
    }
    const double rate = row.at("clocks").get<double>();
    all.push_back({{"name", label}, {"clocks_per_second", rate}});
    const double beside = base ? base(label, rate) : 0;
    if (beside > 0) all.back()["ratio"] = rate / beside;
    if (json) continue;
    print(fmt::format("{:<34} {:8.2f} M clocks/s", label, rate / 1e6));
    if (beside > 0) print(fmt::format("  {:5.2f}", rate / beside));
    print("\n");
  }
}

// Groups of rows, which may be asked for as a unit may.
constexpr const char *Levels = "levels", *Engines = "engines", *Traces = "traces", *Mixes = "mixes",
                     *Host = "host";
constexpr const char* Neighbours = "neighbours";  // only if they are asked for: 30 plug-ins
constexpr const char* Sweep = "sweep";            // only if it is asked for: it takes minutes
constexpr const char* Tlm = "tlm: ";
constexpr const char* Signal = "signal: ";
constexpr const char* Verilated = "verilated: tt_um_racebeam";
constexpr const char* AllRtl = "mix: all RTL";
constexpr double RealTime = 2 * PixelClockHz;  // clocks a second of the chip

/// Clocks that are counted, and not measured.
struct CountedRows {
  const char* name;
  bool if_named;  ///< it takes seconds
  Json (*rows)();
  std::string (*text)(const Json& rows);
};
constexpr CountedRows Counted[] = {{"store", false, store_rows, store_tables},
                                   {"spheres", false, sphere_rows, sphere_text},
                                   {"cores", false, core_rows, core_text},
                                   {"pictures", true, picture_rows, picture_text}};

/// Benchmarks that run in a process of their own, and how many rows they have.
struct Group {
  int rows;
  std::function<void()> prepare;
  Base base;
};

/// Runs groups one after the other, with a bar over all of them.
class GroupRuns {
 public:
  GroupRuns(int rows, bool json, Json& all) : progress_(rows, "rows"), json_(json), all_(all) {}

  void run(const Group& group) {
    int done = done_;  // in the child
    progress_.draw(done, 0);
    const Json rows = run_apart(group.prepare, [&] { progress_.draw(++done, 0); });
    progress_.clear();
    collect(rows, json_, all_, group.base);
    done_ += group.rows;
  }

 private:
  Progress progress_;
  const bool json_;
  Json& all_;
  int done_ = 0;
};

/// What a part of the rows of sweeps is called, if it is asked for alone.
std::string sweep_name(const std::string& part) { return std::string(Sweep) + "-" + part; }

/// Rows of sweeps, which have goals.
void run_sweeps(const std::string& part, int repeats, bool json, Json& all) {
  measure_sweeps(part, repeats, [&](const GoalRow& row) {
    const char* const goal = row.at_least ? "at_least" : "at_most";
    all.push_back({{"name", row.name},
                   {"value", row.value},
                   {"unit", row.unit},
                   {goal, row.goal},
                   {"met", row.met()}});
    if (!json)
      print(fmt::format("{:<42} {:8.3f} {:<6}  {} {:g}{}\n", row.name, row.value, row.unit,
                        row.at_least ? "at least" : "at most", row.goal,
                        row.met() ? "" : ": MISSED"));
  });
}

/// What is known of the slowest part at the level tlm.
Json slowest_tlm(const Json& all) {
  Json worst;
  for (const auto& row : all) {
    const std::string name = row.at("name");
    if (name.rfind(Tlm, 0) != 0) continue;
    const double rate = row.at("clocks_per_second");
    if (worst.is_null() || rate < worst.at("clocks_per_second"))
      worst = {{"part", name.substr(std::string(Tlm).size())},
               {"clocks_per_second", rate},
               {"of_real_time", rate / RealTime},
               {"of_signal", row.value("ratio", 0.0)},
               {"of_verilated", rate / rate_of(all, Verilated)},
               {"real_time", rate >= RealTime}};
  }
  return worst;
}

std::string verdict(const Json& worst) {
  return fmt::format(
      "tlm is {} in its slowest part, {}: {:.2f} times the chip's {:.1f} M clocks/s, {:.1f} times "
      "signal, {:.1f} times the verilated top\n",
      worst.at("real_time").get<bool>() ? "in real time" : "NOT in real time",
      worst.at("part").get<std::string>(), worst.at("of_real_time").get<double>(), RealTime / 1e6,
      worst.at("of_signal").get<double>(), worst.at("of_verilated").get<double>());
}

/// Rows of mixes, with a bar over all runs.
void run_mixes(const std::vector<ChipMix>& mixes, bool with_top, const BenchOptions& options,
               Json& all) {
  Progress progress(mix_runs(mixes, with_top, options), "runs");
  int done = 0;
  const std::vector<MixRow> rows =
      measure_mixes(mixes, with_top, options, [&] { progress.draw(++done, 0); });
  progress.clear();
  for (const MixRow& row : rows) {
    all.push_back({{"name", row.name}, {"clocks_per_second", row.clocks_per_second}});
    if (row.of_models > 0) all.back()["ratio"] = row.of_models;
    if (row.evaluations_a_clock > 0) all.back()["evaluations_a_clock"] = row.evaluations_a_clock;
    if (row.of_top > 0) all.back()["of_verilated"] = row.of_top;
    if (options.json) continue;
    print(fmt::format("{:<38} {:8.2f} M clocks/s", row.name, row.clocks_per_second / 1e6));
    if (row.of_models > 0) print(fmt::format("  {:5.2f}", row.of_models));
    if (row.evaluations_a_clock > 0)
      print(fmt::format("  {:5.2f} evaluations a clock", row.evaluations_a_clock));
    print("\n");
  }
}

double all_rtl_of_verilated(const Json& all) {
  for (const auto& row : all)
    if (row.at("name") == AllRtl) return row.at("of_verilated");
  return 0;
}

}  // namespace

std::vector<std::string> bench_rows() {
  std::vector<std::string> rows = {Levels, Engines, Traces, Mixes, Neighbours, Host, Sweep};
  for (const CountedRows& group : Counted) rows.emplace_back(group.name);
  for (const std::string& part : sweep_parts()) rows.push_back(sweep_name(part));
  for (const unit_row& row : unit_table()) rows.emplace_back(row.name);
  return rows;
}

int command_bench(const BenchOptions& options) {
  const std::vector<std::string> known = bench_rows();
  for (const auto& name : options.rows)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw unknown_name("row", name, known);
  const auto wanted = [&](const std::string& name) {
    return options.rows.empty() ||
           std::find(options.rows.begin(), options.rows.end(), name) != options.rows.end();
  };

  Json all = Json::array();
  std::vector<Group> groups;
  const auto add = [&](int rows, std::function<void()> prepare, Base base = {}) {
    groups.push_back({rows, std::move(prepare), std::move(base)});
  };
  if (wanted(Levels)) {
    add(1, [&] { register_kernel(options.repeats); });
    add(part_count(), [&] { register_parts(options); });
    add(
        part_count() + 1, [&] { register_tlm_parts(options); },
        [&all](const std::string& name, double) {
          return rate_of(all, Signal + name.substr(std::string(Tlm).size()));
        });
    add(1, [&] { register_verilated(Verilated, options.repeats); });
  }
  const std::size_t levels = groups.size();
  if (wanted(Engines))
    for (const EngineLevel& row : engine_levels())
      add(
          1, [&options, row] { register_engine(row, options.repeats); },
          [&all, first = EngineLevel{*engines().front(), row.level}.name()](
              const std::string&, double) { return rate_of(all, first); });
  if (wanted(Traces))
    add(
        TraceRows, [&] { register_traces(options); }, beside_first());
  if (wanted(Host))
    add(HostRows, [&] {
      register_start(options.repeats);
      register_png(options);
    });
  for (const unit_row& row : unit_table())
    if (wanted(row.name)) add(1, [&] { register_unit(row, options.repeats); });

  int rows = 0;
  for (const Group& group : groups) rows += group.rows;
  GroupRuns runs(rows, options.json, all);
  Json worst;
  for (std::size_t n = 0; n < groups.size(); ++n) {
    runs.run(groups[n]);
    if (n + 1 != levels) continue;
    worst = slowest_tlm(all);
    if (!options.json) print(verdict(worst));
  }
  if (wanted(Mixes)) run_mixes(chip_mixes(), true, options, all);
  if (wanted(Mixes) && !options.json)
    print(fmt::format("all RTL has {:.2f} of the speed of the verilated top\n",
                      all_rtl_of_verilated(all)));
  if (!options.rows.empty() && wanted(Neighbours))
    run_mixes(neighbour_mixes(), false, options, all);
  std::map<std::string, Json> counted;
  for (const CountedRows& group : Counted) {
    if (!wanted(group.name) || (group.if_named && options.rows.empty())) continue;
    counted[group.name] = group.rows();
    if (!options.json) print(group.text(counted[group.name]));
  }
  for (const std::string& part : sweep_parts())
    if (!options.rows.empty() && (wanted(Sweep) || wanted(sweep_name(part))))
      run_sweeps(part, options.repeats, options.json, all);
  if (options.json) {
    Json report{{"schema", "racebeam-bench"},
                {"version", 1},
                {"repeats", options.repeats},
                {"frames", options.frames},
                {"medians", all}};
    if (wanted(Levels)) report["slowest_tlm"] = worst;
    if (wanted(Mixes)) report["all_rtl_of_verilated"] = all_rtl_of_verilated(all);
    for (const auto& [name, rows] : counted) report[name] = rows;
    print(report.dump(2) + "\n");
  }
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, BenchOptions& options) {
  command
      .add_option(
          "row", options.rows,
          "Only these: levels, engines, traces, mixes, neighbours, host, store, spheres, cores, "
          "pictures, sweep, a part of it such as sweep-causes, or units; pictures takes seconds, "
          "neighbours and sweep minutes: they are run only if they are named")
      .type_name("ROW");
  add_number(command, "--frames", options.frames, "Frames of each demo part, 1..1000",
             is_number_in("--frames", 1, 1000))
      .capture_default_str();
  add_number(command, "--repeat", options.repeats, "Runs of which the median counts, 1..100",
             is_number_in("--repeat", 1, 100))
      .capture_default_str();
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command bench_row() {
  return make_command<BenchOptions>("bench", "Measure simulated clocks a second", "Measure",
                                    "bench levels --frames 3", add_options, command_bench);
}

}  // namespace racebeam
