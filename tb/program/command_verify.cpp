// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>

#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/bench/surroundings.h"
#include "tb/bench/wired_bench.h"
#include "tb/program/common_options.h"
#include "tb/program/replay_all.h"
#include "tb/program/verify_bench.h"
#include "tb/program/verify_power_up.h"
#include "tb/program/verify_replay.h"
#include "tb/program/verify_report.h"
#include "tb/program/verify_stream.h"
#include "tb/program/verify_unit.h"
#include "tb/program/verify_watch.h"
#include "tb/scene/engines.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/lockstep_report.h"
#include "tb/twin/twins.h"
#include "tb/twin/use_option.h"
#include "tb/verilate/gate_netlist.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

long long frames_of(const VerifyOptions& options, const Show& show) {
  if (options.frames != VerifyOptions::UsualFrames) return options.frames;
  return std::min(show.engine().races_beam ? 60 : 2, show.frames());
}

bool all_differ(const WiredBench& bench) {
  const auto units = bench.locksteps();
  return std::all_of(units.begin(), units.end(),
                     [](auto* unit) { return unit->first() || unit->fault(); });
}

/// A frame; or those of a picture, until there is nothing more to find.
void show_frame(WiredBench& bench, const Raster& raster) {
  const Surroundings* around = bench.around();
  const int pictures = around ? around->pictures() : 0;
  do bench.advance(raster.frame_clocks());
  while (around && around->pictures() == pictures && !all_differ(bench));
}

/// What the user wrote of a unit, for a command that repeats a run.
std::string word_of(const VerifyOptions& options, const std::string& unit) {
  for (const std::string& word : options.units)
    if (word.rfind(unit + "=", 0) == 0) return word;
  return unit;
}

/// UNIT=FILE: built with signals inside, so that a difference can be told with its registers. A
/// whole chip and gates have too many.
bool is_file_of_unit(const std::string& word, const engine& of) {
  const auto equals = word.find('=');
  return equals != std::string::npos && word.substr(0, equals) != of.top &&
         !gate_word(word.substr(equals + 1));
}

/// `rest`: what else it takes, with a space before it.
std::string repeat_text(const VerifyOptions& options, const std::string& unit,
                        const std::string& rest) {
  return fmt::format("racebeam verify {} --scene {}{}{}", word_of(options, unit), options.scene,
                     rest, options.set_text());
}
std::string repeat_text(const VerifyOptions& options, const std::string& unit, long long frames,
                        long long random) {
  const std::string starts =
      options.power_up > 0 ? fmt::format(" --power-up {}", options.power_up) : "";
  return repeat_text(options, unit,
                     fmt::format(" --frames {} --random {} --seed {}{}{}", frames, random,
                                 options.seed, starts, options.text() + options.delays_text()));
}

/// The first clock of a frame or picture, as `trace --from` takes it.
std::string frame_option(const Show& show, int frame) {
  return fmt::format("{}:{}", frame, show.engine().races_beam ? FirstLine : 0);
}

/// The command that shows the chip around a difference in a frame.
std::string closer_text(const VerifyOptions& options, const std::string& unit,
                        const std::string& from) {
  const std::string word = word_of(options, unit), file = word.substr(unit.size());
  const std::string use = unit + "=lockstep" + (file.empty() ? "" : ":" + file.substr(1));
  return trace_command(
      options.scene, from, unit,
      " --use " + use + options.set_text() + options.text() + options.delays_text());
}

/// All units at once, in the chip, over frames spread over the show, until each has differed or
/// ended.
std::vector<UnitVerdict> verify_in_chip(const VerifyOptions& options, const Show& show,
                                        const knob_values& k, const unit_choices& choices) {
  const auto start = std::chrono::steady_clock::now();
  WiredBench::Watches watches;
  watches.outlive_faults = true;
  const planned_stalls stalls(stall_plan_of(show.engine(), options));
  const planned_delays delays(delay_plan_of(show.engine(), options));
  WiredBench bench({show.engine(), k, show.tables(), show.frames(), choices}, watches);
  const Raster raster = raster_of(show.engine(), k);
  std::vector<int> frames;
  const long long number = frames_of(options, show);
  Progress progress(static_cast<int>(number));
  for (int i = 0; i < number && !interrupted() && !all_differ(bench); ++i) {
    const int frame = static_cast<int>(i * show.frames() / number);
    bench.seek(frame);
    frames.resize(bench.clocks() / static_cast<std::uint64_t>(raster.frame_clocks()),
                  frames.empty() ? frame : frames.back());
    frames.push_back(frame);
    try {
      show_frame(bench, raster);
    } catch (const Interrupted&) {
      break;
    }
    frames.resize(bench.clocks() / static_cast<std::uint64_t>(raster.frame_clocks()), frame);
    progress.draw(i + 1, bench.clocks());
  }
  progress.clear();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<UnitVerdict> verdicts;
  for (const Lockstep* unit : bench.locksteps()) {
    UnitVerdict verdict{unit->unit(),
                        "chip",
                        unit->clocks(),
                        unit->masked(),
                        unit->differences(),
                        seconds,
                        {},
                        unit->fault().value_or("")};
    if (!verdict.fault.empty()) {
      const BeamPlace place = place_of(unit->clocks(), frames, raster);
      verdict.fault +=
          " (" +
          (show.engine().races_beam ? place_text(place, raster) : picture_text(place, raster)) +
          ")";
    }
    if (const auto& d = unit->first()) {
      const BeamPlace place = place_of(d->clock, frames, raster);
      const DifferenceContext context{
          "in " +
              (show.engine().races_beam ? place_text(place, raster) : picture_text(place, raster)),
          repeat_text(options, unit->unit(), number, 0),
          closer_text(options, unit->unit(), frame_option(show, place.frame)),
          save_chip_window(*d, {show, raster, frames}, k, options.folder), knobs_text(k)};
      verdict.first =
          FirstDifference{d->port, d->clock, d->expected, d->got, place, explain(*d, context)};
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

/// A unit by itself, in a process of its own: SystemC elaborates once in one. What ends that ends
/// the unit's comparison.
UnitVerdict in_a_process(const std::string& unit, const char* traffic,
                         const std::function<UnitVerdict()>& verify) {
  try {
    return verdict_of(Json::parse(forked([&] { return to_json(verify()).dump(); })));
  } catch (const ChildDied& death) {
    return {unit, traffic, 0, 0, 0, 0, {}, death.what()};
  }
}

UnitVerdict verify_alone(const VerifyOptions& options, const UnitUnderTest& dut, Stimulus stimulus,
                         std::uint64_t clocks, const std::function<void(std::uint64_t)>& compared) {
  return in_a_process(dut.unit, stimulus == Stimulus::Random ? "random" : "walk", [&] {
    return verify_unit(dut, stimulus, clocks, static_cast<unsigned>(options.seed), options.folder,
                       repeat_text(options, dut.unit, 0, options.random), compared);
  });
}

/// The same with signals inside: of the project's own RTL, which has none where nothing differs.
UnitUnderTest readable(UnitUnderTest dut, const VerifyOptions& options) {
  if (word_of(options, dut.unit) == dut.unit)
    dut.plugin = twins_of(engine_of(dut.k)).plugins(dut.k, dut.scene, true).own(dut.unit);
  return dut;
}

/// What was found alone, in few clocks; as it was, if that is not to be had.
void shrink(UnitVerdict& verdict, const VerifyOptions& options, const UnitUnderTest& dut,
            Stimulus stimulus) {
  if (!verdict.first || options.no_shrink || interrupted()) return;
  const UnitVerdict found = verdict;
  try {
    const UnitVerdict shrunk = in_a_process(dut.unit, verdict.traffic.c_str(), [&] {
      UnitVerdict small = found;
      shrink_difference(*small.first, readable(dut, options), stimulus,
                        static_cast<unsigned>(options.seed), options.folder,
                        repeat_text(options, dut.unit, ""));
      return small;
    });
    if (shrunk.first) verdict = shrunk;
    else tell(dut.unit + ": the difference is not shrunk: " + shrunk.fault);
  } catch (const Interrupted&) {
  }
}

/// The unit of the command line on a stream from a file, and nothing else.
std::vector<UnitVerdict> verify_on_stream(const VerifyOptions& options, const Show& show,
                                          const knob_values& k, const unit_choices& choices) {
  const auto& [unit, choice] = *choices.by_unit.begin();
  const UnitUnderTest dut{unit, choice.plugin, k, show.tables(), show.frames()};
  return {in_a_process(unit, "stream", [&] {
    return verify_stream(dut, options.stream, options.folder,
                         repeat_text(options, dut.unit, " --stream " + options.stream));
  })};
}

/// A unit from many power-ups.
UnitVerdict verify_starts(const VerifyOptions& options, const UnitUnderTest& dut) {
  PowerUpOptions wanted;
  wanted.seeds = static_cast<int>(options.power_up);
  wanted.traffic = static_cast<unsigned>(options.seed);
  return in_a_process(dut.unit, "power-up", [&] {
    return verify_power_up(dut, wanted, repeat_text(options, dut.unit, 0, 0));
  });
}

/// The bench of what was played to the unit of the command line: of a stream, of a difference in
/// few clocks, or of random traffic as far as it was compared.
void write_bench(const VerifyOptions& options, const UnitUnderTest& dut,
                 const std::vector<UnitVerdict>& verdicts) {
  BenchTraffic traffic{options.stream,
                       static_cast<std::uint64_t>(options.random),
                       static_cast<unsigned>(options.seed),
                       {}};
  std::string rest = fmt::format(" --random {} --seed {}", options.random, options.seed);
  for (const UnitVerdict& verdict : verdicts) {
    if (!verdict.first || verdict.traffic == "stream") continue;
    if (verdict.first->shrunk) traffic.stream = verdict.first->shrunk->stream;
    else if (verdict.traffic == "random") traffic.clocks = verdict.first->clock + 1;
    else continue;
    break;
  }
  if (!traffic.stream.empty()) rest = " --stream " + traffic.stream;
  else if (traffic.clocks > BenchTraffic::MostClocks)
    tell(fmt::format("{}: the first {} clocks of {}", options.bench, BenchTraffic::MostClocks,
                     traffic.clocks));
  traffic.command = repeat_text(options, dut.unit, rest + " --bench-out " + options.bench);
  forked([&] {
    write_bench(dut, traffic, options.bench);
    return std::string();
  });
}

/// Each unit by itself: the walk of one that has a walk, and random traffic.
std::vector<UnitVerdict> verify_at_random(const VerifyOptions& options, const Show& show,
                                          const knob_values& k, const unit_choices& choices) {
  std::vector<UnitVerdict> verdicts;
  const auto walk_clocks = [&](const std::string& unit) {
    const UnitWalk* const walk = twins_of(show.engine()).walk(unit);
    return walk ? walk->clocks : 0;
  };
  std::uint64_t all = 0, done = 0;  // clocks
  for (const auto& [unit, choice] : choices.by_unit)
    if (unit != show.engine().top)
      all += walk_clocks(unit) + static_cast<std::uint64_t>(options.random);
  Progress progress(static_cast<std::int64_t>(all), "clocks of units alone");
  const auto verify = [&](const UnitUnderTest& dut, Stimulus stimulus, std::uint64_t clocks) {
    const auto draw = [&](std::uint64_t compared) {
      progress.draw(static_cast<std::int64_t>(done + compared), done + compared, dut.unit);
    };
    draw(0);
    verdicts.push_back(verify_alone(options, dut, stimulus, clocks, draw));
    progress.clear();
    shrink(verdicts.back(), options, dut, stimulus);
    done += clocks;
  };
  for (const auto& [unit, choice] : choices.by_unit) {
    if (unit == show.engine().top) continue;  // the whole chip has its own traffic only
    const UnitUnderTest dut{unit, choice.plugin, k, show.tables(), show.frames()};
    try {
      if (const std::uint64_t clocks = walk_clocks(unit);
          clocks > 0 && options.random > 0 && !interrupted())
        verify(dut, Stimulus::Walk, clocks);
      if (interrupted()) break;
      if (options.random > 0)
        verify(dut, Stimulus::Random, static_cast<std::uint64_t>(options.random));
      if (options.power_up > 0 && !interrupted()) verdicts.push_back(verify_starts(options, dut));
    } catch (const Interrupted&) {
      break;
    }
  }
  return verdicts;
}

}  // namespace

Run plan_verify(const VerifyOptions& options) {
  if (!options.stream.empty()) {
    const std::string unit = unit_of_stream(options.stream);
    if (options.units.size() != 1 || options.units[0].substr(0, options.units[0].find('=')) != unit)
      throw UsageError(fmt::format(
          "{} is a stream for {}; name that unit and no other, as in 'racebeam verify {} --stream "
          "{}'",
          options.stream, unit, unit, options.stream));
  }
  if (!options.bench.empty() && (options.units.size() != 1 || options.units[0] == "all"))
    throw UsageError(
        "--bench-out is for one unit; name that and no other, as in 'racebeam verify "
        "stacks --bench-out stacks_bench.v'");
  if (!options.bench.empty() && options.stream.empty() && options.random == 0)
    throw UsageError("--bench-out is of random traffic or of a --stream; leave out --random 0");
  if (options.frames == 0 && options.random == 0 && options.power_up == 0)
    throw UsageError("--frames 0 and --random 0 compare nothing; leave out one of them");
  Run run = open_run(options, true);
  const long long frames = frames_of(options, run.show);
  if (frames > run.show.frames())
    throw UsageError(
        fmt::format("--frames {} is out of range; the scene has {}", frames, run.show.frames()));
  stall_plan_of(run.show.engine(), options);
  leave_out_whole_chip(run.show.engine(), options, options.units, run.units);
  if (!options.shake.empty() && frames == 0)
    throw UsageError("--shake stalls the chip's own traffic; leave out --frames 0, or --shake");
  if (!options.delays.empty() && frames == 0)
    throw UsageError("--delays delays the chip's own traffic; leave out --frames 0, or --delays");
  delay_plan_of(run.show.engine(), options);
  check_delays(run.show.engine(), options, options, options.units, run.units);
  try_folder(options.folder);  // a difference may be found after an hour
  return run;
}

int command_verify(const VerifyOptions& options) {
  if (options.replay != AllFrames && (options.first != VerifyOptions::Spread || options.jobs > 0 ||
                                      options.minutes > 0 || !options.record.empty()))
    throw UsageError("--first, --jobs, --minutes and --record are of --replay all");
  if (!options.replay.empty()) return verify_replay(options);
  auto [show, level, k, choices] = plan_verify(options);
  const bool inside = options.power_up > 0 || !options.bench.empty();
  const UseOption use(show.engine(), k, show.tables(), inside);
  const UseOption use_readable(show.engine(), k, show.tables(), true);
  if (options.units.empty()) use.lockstep(choices, "all");
  for (const std::string& word : options.units)
    (is_file_of_unit(word, show.engine()) ? use_readable : use).lockstep(choices, word);
  leave_out_whole_chip(show.engine(), options, options.units, choices);
  catch_interrupts();
  std::vector<UnitVerdict> verdicts;
  const bool streams = !options.stream.empty(), benched = !options.bench.empty();
  if (streams) verdicts = verify_on_stream(options, show, k, choices);
  else if (options.random > 0 || options.power_up > 0)
    verdicts = verify_at_random(options, show, k, choices);
  for (const UnitVerdict& verdict : verdicts)
    if (!verdict.fault.empty()) choices.by_unit.erase(verdict.unit);
  if (benched && !interrupted() && !choices.by_unit.empty()) {
    const auto& [unit, choice] = *choices.by_unit.begin();
    write_bench(options, {unit, choice.plugin, k, show.tables(), show.frames()}, verdicts);
  }
  if (!streams && !benched && frames_of(options, show) > 0 && !interrupted() &&
      !choices.by_unit.empty())
    for (const UnitVerdict& verdict : verify_in_chip(options, show, k, choices))
      verdicts.push_back(verdict);

  return tell_verdicts(verdicts, options.seed, options.json);
}

namespace {

constexpr long long MostRandomClocks = 1'000'000'000'000;
constexpr long long LargestSeed = 0xffffffff;
constexpr long long MostJobs = 256, MostMinutes = 100'000;
constexpr long long MostPowerUps = 1'000'000;

void add_options(const CommandOptions& command, VerifyOptions& options) {
  command
      .add_option("unit", options.units,
                  "UNIT; UNIT=FILE.sv, UNIT=A.sv+B.sv, UNIT=LIST.f, UNIT=FOLDER; or all")
      .type_name("UNIT");
  command.add_option("--scene", options.scene, "demo, or a scene file")
      .type_name("SCENE")
      .capture_default_str();
  const CommandOption frames = add_number(
      command, "--frames", options.frames,
      "Frames of the chip, spread over the scene; 60, or 2 whole pictures of an engine that "
      "does not race the beam",
      is_number("--frames", "0..12799 in the demo"));
  const CommandOption random =
      add_number(command, "--random", options.random, "Clocks of random traffic for each unit",
                 is_number_in("--random", 0, MostRandomClocks))
          .capture_default_str();
  add_number(
      command, "--power-up", options.power_up,
      "Random values of the registers at power-up, for each unit: what shows after the reset",
      is_number_in("--power-up", 0, MostPowerUps))
      .capture_default_str();
  add_run_options(command, options);
  add_shake_options(command, options);
  add_delay_options(command, options);
  add_number(command, "--seed", options.seed, "Of the random traffic",
             is_number_in("--seed", 0, LargestSeed))
      .capture_default_str();
  command.add_option("-o,--output", options.folder, "Folder for the waveforms of differences")
      .type_name("DIR")
      .check(not_empty)
      .capture_default_str();
  command
      .add_option("--stream", options.stream,
                  "Instead of frames and random traffic: the clocks in this file, as a shrunk "
                  "difference leaves it")
      .type_name("FILE")
      .check(not_empty)
      .excludes(frames)
      .excludes(random);
  command.add_flag("--no-shrink", options.no_shrink,
                   "Leave a difference on random traffic as it was found");
  command
      .add_option("--replay", options.replay,
                  "Traffic that `racebeam capture` wrote, into the RTL alone; UNIT=model too; all: "
                  "every frame of the scene, or --frames of them, kept in parts in -o")
      .type_name("FILE")
      .check(not_empty);
  add_number(command, "--first", options.first,
             "Of --replay all: the first of --frames consecutive frames; else they are spread over "
             "the scene",
             is_number_in("--first", 0, std::numeric_limits<int>::max()));
  add_number(command, "--jobs", options.jobs,
             "Of --replay all: processes; else as many as there are processors",
             is_number_in("--jobs", 1, MostJobs));
  add_number(command, "--minutes", options.minutes,
             "Of --replay all: after these no part begins; the same command goes on",
             is_number_in("--minutes", 1, MostMinutes));
  command
      .add_option("--record", options.record,
                  "Of --replay all: write what was compared to this file, a row for each unit")
      .type_name("FILE")
      .check(not_empty);
  command
      .add_option("--bench-out", options.bench,
                  "Instead of frames: write what is compared of one unit, a difference in few "
                  "clocks, as a self-checking test bench in Verilog-2001")
      .type_name("FILE.v")
      .check(not_empty)
      .excludes(frames);
  command.add_flag("--watch", options.watch, "Again whenever one of the RTL's files is saved");
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

int run(const VerifyOptions& options) {
  return options.watch ? verify_watch(options) : command_verify(options);
}

}  // namespace

Command verify_row() {
  return make_command<VerifyOptions>("verify", "Compare model and RTL of units in every clock",
                                     "Verify", "verify stacks=mine.sv", add_options, run);
}

}  // namespace racebeam
