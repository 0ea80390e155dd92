// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_capture.h"

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <memory>
#include <numeric>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/file_lock.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/bench/chip_traffic.h"
#include "tb/program/common_options.h"
#include "tb/program/run_traffic.h"
#include "tb/twin/twins.h"
#include "tb/twin/unit_traffic.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

std::vector<int> visits_of(const CaptureOptions& options, const Show& show) {
  const long long all = show.frames(), first = options.first;
  if (first == CaptureOptions::Spread) {
    if (options.frames > all)
      throw UsageError(
          fmt::format("--frames {} is out of range; the scene has {}", options.frames, all));
    std::vector<int> visits;
    for (long long i = 0; i < options.frames; ++i)
      visits.push_back(static_cast<int>(i * all / options.frames));
    return visits;
  }
  if (first >= all || first + options.frames > all)
    throw UsageError(fmt::format("--first {} --frames {} is out of range; the scene has {}", first,
                                 options.frames, all));
  std::vector<int> visits(static_cast<std::size_t>(options.frames));
  std::iota(visits.begin(), visits.end(), static_cast<int>(first));
  return visits;
}

void check_unit(const CaptureOptions& options, const Run& run) {
  if (options.unit == run.show.engine().top)
    throw UsageError(options.unit +
                     " is put to a frame through back doors, not through its pins: capture one of "
                     "its units");
  unit_choices none;
  UseOption(run.show.engine(), run.k, run.show.tables()).use(none, options.unit + "=model");
}

/// What is captured of whom, and where it goes.
class Capture {
 public:
  Capture(const CaptureOptions& options, const Run& run) : options_(options), run_(run) {}

  void chip() {
    const std::vector<int> visits = visits_of(options_, run_.show);
    const Show& show = run_.show;
    Progress progress(static_cast<std::int64_t>(visits.size()));
    record_chip_traffic({show.engine(), run_.k, show.tables(), show.frames()}, options_.unit,
                        visits, opener("chip"),
                        [&](int frames, std::uint64_t clocks) { progress.draw(frames, clocks); });
  }
  void alone() {
    const UnitWalk* const walk = twins_of(run_.show.engine()).walk(options_.unit);
    if (options_.walk && !walk) throw UsageError(options_.unit + " has no walk; leave out --walk");
    const auto clocks = options_.walk ? walk->clocks : static_cast<std::uint64_t>(options_.random);
    Progress progress(static_cast<std::int64_t>(clocks), "clocks of the unit alone");
    record_lone_traffic(
        {options_.unit, "", run_.k, run_.show.tables(), run_.show.frames()},
        options_.walk ? LoneTraffic::Walk : LoneTraffic::Random, clocks,
        static_cast<unsigned>(options_.seed), opener(options_.walk ? "walk" : "random"),
        [&](std::uint64_t done) { progress.draw(static_cast<std::int64_t>(done), done); });
  }
  TrafficWriter& writer() { return *writer_; }

 private:
  OpenSink opener(const std::string& source) {
    return [this, source](const std::vector<PortTraffic::Port>& ports) -> TrafficSink& {
      writer_ = std::make_unique<TrafficWriter>(options_.file,
                                                traffic_head(run_, options_.unit, source, ports));
      return *writer_;
    };
  }

  const CaptureOptions& options_;
  const Run& run_;
  std::unique_ptr<TrafficWriter> writer_;
};

}  // namespace

int command_capture(const CaptureOptions& options) {
  if (options.random > 0 && options.walk)
    throw UsageError("--random and --walk are two captures; leave out one of them");
  const Run run = open_run(options, true);
  check_unit(options, run);
  { OutputFile(options.file); }  // it may take hours to come to it
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  Capture capture(options, run);
  if (options.random > 0 || options.walk) capture.alone();
  else capture.chip();
  capture.writer().commit();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto clocks = static_cast<double>(capture.writer().clocks());
  tell(fmt::format("{}: {} clocks of {} in {} bytes, {:.2f} M clocks/s", options.file,
                   capture.writer().clocks(), options.unit, capture.writer().bytes(),
                   seconds > 0 ? clocks / seconds / 1e6 : 0));
  return ExitGood;
}

namespace {

constexpr long long MostRandomClocks = 1'000'000'000'000;
constexpr long long LargestSeed = 0xffffffff;

void add_options(const CommandOptions& command, CaptureOptions& options) {
  command.add_option("unit", options.unit, "UNIT").type_name("UNIT").required();
  command.add_option("--scene", options.scene, "demo, or a scene file")
      .type_name("SCENE")
      .capture_default_str();
  add_number(command, "--first", options.first,
             "First of consecutive frames; else they are spread over the scene, as those of verify",
             is_number_in("--first", 0, std::numeric_limits<int>::max()));
  add_number(command, "--frames", options.frames, "Frames of the chip, or pictures",
             is_number_in("--frames", 1, std::numeric_limits<int>::max()))
      .capture_default_str();
  add_number(command, "--random", options.random, "Clocks of random traffic, instead of the chip's",
             is_number_in("--random", 1, MostRandomClocks));
  command.add_flag("--walk", options.walk, "The unit's walk, instead of the chip's traffic");
  add_number(command, "--seed", options.seed, "Of the random traffic",
             is_number_in("--seed", 0, LargestSeed))
      .capture_default_str();
  add_run_options(command, options);
  command.add_option("-o,--output", options.file, "File for the traffic")
      .type_name("FILE")
      .check(not_empty)
      .required();
}

}  // namespace

Command capture_row() {
  return make_command<CaptureOptions>("capture", "Write the traffic of a unit's ports to a file",
                                      "Verify", "capture stacks -o stacks.traffic", add_options,
                                      command_capture);
}

}  // namespace racebeam
