// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/sweep_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <thread>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/spread_frames.h"
#include "tb/bench/tlm_bench.h"
#include "tb/judge/error_causes.h"
#include "tb/speed/sweep_bench.h"
#include "tb/sweep/interval.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/silicon_plan.h"

namespace racebeam {

namespace {

constexpr const char* Frames = "frames = {{ sample = {}, guard = 0 }}\n";

struct Least {
  double value = std::numeric_limits<double>::infinity();

  void take(double one) { value = std::min(value, one); }
};

template <class Measure>
double least_of(int repeats, const Measure& measure) {
  Least least;
  for (int i = 0; i < repeats; ++i) least.take(measure());
  return least.value;
}

/// Points of one knob, all of them measured to the end.
std::string hurry_sweep(int sample, const char* values) {
  return fmt::format(Frames, sample) +
         fmt::format("knobs.hurry_threshold = {}\nsearch.race = false\n", values);
}
constexpr const char *Alone = "32", *Eight = "[0, 4, 8, 16, 24, 48, 64, 128]";
constexpr int Values[] = {0, 4, 8, 16, 24, 48, 64, 128};

/// What a point costs beside one `render` of its frames without files: eight of them, each in a
/// sweep that has the base and the reference pictures. The start of the program counts on neither
/// side: what the same command takes that finds all, and --version. They run in turn, so that
/// other work on the machine does the same to all.
double overhead(const SweepBench& bench, int sample, int repeats) {
  bench.run_anew(hurry_sweep(sample, Alone), "base");
  double points = 0, rendering = 0;
  for (const int value : Values) {
    const std::string text = hurry_sweep(sample, std::to_string(value).c_str());
    const std::string setting = fmt::format("hurry_threshold={}", value);
    Least point, again, render, start;
    for (int i = 0; i < repeats; ++i) {
      bench.copy("base", "overhead");
      point.take(bench.run(text, "overhead").cpu_seconds);
      again.take(bench.run(text, "overhead").cpu_seconds);
      render.take(bench.render(text, sample, setting).cpu_seconds);
      start.take(run_program({"--version"}).cpu_seconds);
    }
    points += point.value - again.value;
    rendering += render.value - start.value;
  }
  return points / rendering;
}

double two_cores(const SweepBench& bench, int repeats) {
  const std::string text = hurry_sweep(256, Eight);
  Least one, two;
  for (int i = 0; i < repeats; ++i) {
    one.take(bench.run_anew(text, "cores", 1).seconds);
    two.take(bench.run_anew(text, "cores", 2).seconds);
  }
  return one.value / two.value;
}

/// Until half of the interval of decisions is 1 % of them; in steps of 16.
double frames_for_one_percent(const SweepBench& bench) {
  constexpr std::size_t Most = 2048, Step = 16;
  const std::vector<int> order = bench.plan("").scenes.front().order;
  return std::stod(forked([&] {
    TlmBench chip({{}, true});
    std::vector<std::pair<int, double>> taken;
    for (std::size_t n = 0; n < Most; ++n) {
      chip.seek(order[n]);
      taken.emplace_back(order[n], double(chip.render().stats->counters.at(1)));
      if (n % Step != Step - 1) continue;
      std::vector<std::pair<int, double>> sorted = taken;
      std::sort(sorted.begin(), sorted.end());
      Stratum stratum{{}, {}, static_cast<int>(order.size())};
      for (const auto& [frame, value] : sorted) {
        stratum.frames.push_back(frame);
        stratum.values.push_back(value);
      }
      if (const Estimate mean = mean_of({stratum}); mean.half_width <= 0.01 * mean.value)
        return std::to_string(n + 1);
    }
    return std::to_string(Most);
  }));
}

struct Causes {
  double fresh, shared, second_reference;  // seconds a frame
};

Causes causes() {
  constexpr int Count = 12, Again = 100;
  std::istringstream seconds(forked([&] {
    const Show show;
    const ErrorChain chain(show, {}, PictureReference::Geometry);
    TlmBench bench({{}, true});
    double fresh = 0, shared = 0, second = 0;
    for (const int frame : spread_frames(show.frames(), Count)) {
      bench.seek(frame);
      const GoldenPicture own = bench.render().picture.colours, end = chain.end().picture(frame);
      ErrorChain::Links links;
      const double begin = processor_seconds();
      chain.by_cause(frame, own, end, links);
      const double middle = processor_seconds();
      chain.by_cause(frame, own, end, links);
      shared += processor_seconds() - middle;
      fresh += middle - begin;
      const std::string kept = packed_colours(end);
      GoldenPicture again = end;
      const double before = processor_seconds();
      for (int i = 0; i < Again; ++i) unpack_colours(kept, again);
      second += (processor_seconds() - before) / Again;
    }
    return fmt::format("{} {} {}", fresh / Count, shared / Count, second / Count);
  }));
  Causes causes{};
  seconds >> causes.fresh >> causes.shared >> causes.second_reference;
  return causes;
}

struct Silicon8 {
  static constexpr const char* Sobol =
      "[knobs]\ninterval_stack_depth = [1, 2, 3, 4, 6, 8]\nfifo_entries = [6, 8, 10, 12, 16]\n"
      "fifo_short_length_bits = [4, 5, 6, 7, 10]\nhurry_threshold = [0, 8, 16, 32, 64, 128]\n"
      "dr_bits = [8, 9, 10, 11, 12]\ncorner_factor_bits = [6, 7, 8, 9, 12]\n"
      "partial_products_cut = [0, 4, 5, 6, 7, 8]\nface_stack_depth = [7, 8, 9, 10]\n"
      "[goals]\npicture_error = \"min\"\ncells = \"min\"\n[measure]\nsilicon = \"generic\"\n";
  static constexpr const char* Grid =
      "[knobs]\ninterval_stack_depth = [1, 2, 3, 4, 6, 8]\n"
      "fifo_entries = [6, 8, 9, 10, 12, 16]\nhurry_threshold = [0, 16, 32, 64, 128]\n";

  static std::string sobol(int sample, bool race) {
    return fmt::format(Frames, sample) +
           fmt::format("search = {{ method = \"sobol\", points = 64, race = {} }}\n{}", race,
                       Sobol);
  }
};

double syntheses(const SweepBench& bench, const std::string& text) {
  const SweepPlan plan = bench.plan(text);
  const Silicon silicon(plan.scenes.front().show.engine());
  SiliconPlan units(silicon, [](const std::string&) { return std::nullopt; });
  for (const PlannedPoint& point : plan.points) units.want(point.k.front());
  return double(units.missing().size()) / double(units.without_sharing());
}

std::set<std::string> front_of(const ProgramRun& run) {
  std::set<std::string> names;
  std::istringstream lines(run.out);
  for (std::string line, word, name; std::getline(lines, line);) {
    std::istringstream words(line);
    if (words >> word >> name && word == "front") names.insert(name);
  }
  return names;
}

struct Race {
  double frames, kept;  // of all frames, of the front
};

Race race(const SweepBench& bench, int sample) {
  const auto all = front_of(bench.run(Silicon8::sobol(sample, false), "race"));
  const std::string text = Silicon8::sobol(sample, true);
  const auto raced = front_of(bench.run(text, "race"));
  const auto kept = std::count_if(all.begin(), all.end(),
                                  [&](const std::string& name) { return raced.count(name); });
  const double points = double(bench.plan(text).points.size());
  return {double(bench.frames_raced(text, "race", sample)) / (points * sample),
          double(kept) / double(all.size())};
}

struct Again {
  double starts, megabytes;
};

/// The same command on 1,000 points of 256 frames, all there.
Again again(const SweepBench& bench, int repeats) {
  constexpr int Sample = 256;
  const std::string text = hurry_sweep(Sample, "{ from = 0, to = 99 }") +
                           "knobs.interval_stack_depth = [1, 2, 3, 4, 5, "
                           "6, 7, 8, 12, 16]\n";
  Again found{};
  found.megabytes = bench.run_anew(hurry_sweep(Sample, Alone), "again").megabytes;
  bench.fill(text, "again");
  found.megabytes = std::max(found.megabytes, bench.run(text, "again").megabytes);
  found.starts = least_of(repeats, [&] { return bench.run(text, "again").cpu_seconds; }) /
                 least_of(repeats, [] { return run_program({"--version"}).cpu_seconds; });
  return found;
}

/// Rows with goals, and who gets them.
struct Rows {
  const std::function<void(const GoalRow&)>& row;

  void at_most(const std::string& name, const char* unit, double value, double goal) const {
    row({"sweep: " + name, unit, value, goal, false});
  }
  void at_least(const std::string& name, double value, double goal) const {
    row({"sweep: " + name, "x", value, goal, true});
  }
};

void measure_points(const SweepBench& bench, int repeats, const Rows& rows) {
  rows.at_most("points of 64 frames, of rendering", "x", overhead(bench, 64, repeats), 1.06);
  rows.at_most("points of 256 frames, of rendering", "x", overhead(bench, 256, repeats), 1.02);
}

void measure_cores(const SweepBench& bench, int repeats, const Rows& rows) {
  if (std::thread::hardware_concurrency() > 1)
    rows.at_least("two cores, of one", two_cores(bench, repeats), 1.85);
  else tell("two cores against one: this machine has one");
}

void measure_decisions(const SweepBench& bench, int, const Rows& rows) {
  rows.at_most("decisions known to 1 %", "frames", frames_for_one_percent(bench), 384);
}

void measure_causes(const SweepBench&, int, const Rows& rows) {
  const Causes of = causes();
  rows.at_most("errors by cause, a frame", "ms", of.fresh * 1e3, 100);
  rows.at_most("errors by cause, links known", "ms", of.shared * 1e3, 6);
  rows.at_most("reference picture, second use", "ms", of.second_reference * 1e3, 0.3);
}

void measure_again(const SweepBench& bench, int repeats, const Rows& rows) {
  const Again found = again(bench, repeats);
  rows.at_most("1,000 points, all there, of a start", "x", found.starts, 4);
  rows.at_most("memory of 1,000 points", "MB", found.megabytes, 150);
}

void measure_racing(const SweepBench& bench, int, const Rows& rows) try {
  rows.at_most("syntheses, of units x 65 points", "x", syntheses(bench, Silicon8::sobol(64, true)),
               0.25);
  rows.at_most("syntheses, of units x 180 points", "x", syntheses(bench, Silicon8::Grid), 0.03);
  bench.run_anew(Silicon8::sobol(256, false), "race",
                 static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  for (const auto& [sample, goal] : {std::pair(64, 0.55), std::pair(256, 0.4)}) {
    const Race raced = race(bench, sample);
    rows.at_most(fmt::format("racing to {} frames, of all frames", sample), "x", raced.frames,
                 goal);
    rows.at_least(fmt::format("racing to {} frames, of the front", sample), raced.kept, 1);
  }
} catch (const MissingTool& error) {
  tell(fmt::format("syntheses and racing: {}", error.what()));
}

struct Part {
  const char* name;
  void (*measure)(const SweepBench& bench, int repeats, const Rows& rows);
};
constexpr Part Parts[] = {{"points", measure_points},       {"cores", measure_cores},
                          {"decisions", measure_decisions}, {"causes", measure_causes},
                          {"again", measure_again},         {"racing", measure_racing}};

}  // namespace

std::vector<std::string> sweep_parts() {
  std::vector<std::string> names;
  for (const Part& part : Parts) names.emplace_back(part.name);
  return names;
}

void measure_sweeps(const std::string& part, int repeats,
                    const std::function<void(const GoalRow&)>& row) {
  const SweepBench bench;
  for (const Part& one : Parts)
    if (one.name == part) one.measure(bench, repeats, {row});
}

}  // namespace racebeam
