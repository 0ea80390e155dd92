// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_replay.h"

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>

#include "sc/base/constants.h"
#include "sc/beam/chip_deposit.h"
#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/program/replay_all.h"
#include "tb/program/run_traffic.h"
#include "tb/program/verify_report.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/lockstep_report.h"
#include "tb/twin/traffic_replay.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// In a process of its own: SystemC elaborates once.
std::unique_ptr<TrafficPlayer> player_of(const Replay& replay, const TrafficHead& head) {
  if (replay.dut.plugin == ModelPlayer) return play_model(replay.dut, head);
  return play_rtl(replay.dut, head);
}

FirstDifference first_of(const Replay& replay, const TrafficSource& source,
                         const LockstepDifference& d) {
  const Show& show = replay.run.show;
  const std::string& folder = replay.folder;
  FirstDifference first{d.port, d.clock, d.expected, d.got, {}, {}};
  if (source.marks().empty()) {
    first.text =
        explain(d, {"on " + source.head().source + " traffic", replay.repeat(), "",
                    save_unit_window(d, "replay", replay.run.k, folder), knobs_text(replay.run.k)});
    return first;
  }
  const Raster raster = replay.run.raster();
  const std::vector<int> frames = frames_of(source.marks(), source.clocks(), raster);
  first.place = place_of(d.clock, frames, raster);
  const std::string place = show.engine().races_beam ? place_text(*first.place, raster)
                                                     : picture_text(*first.place, raster);
  first.text = explain(d, {"in " + place, replay.repeat(), "",
                           save_chip_window(d, {show, raster, frames}, replay.run.k, folder),
                           knobs_text(replay.run.k)});
  return first;
}

UseOption use_of(const Run& run) { return {run.show.engine(), run.k, run.show.tables()}; }

/// Of the whole chip.
std::vector<std::string> deposited_registers() {
  std::vector<std::string> names;
  for (const auto& [name, value] : chip_deposits(0, navigator_core())) names.push_back(name);
  return names;
}

}  // namespace

std::string Replay::repeat() const {
  const std::string run_text = " --scene " + options.scene + options.set_text();
  const std::string file = captured.empty() ? options.replay : dut.unit + ".traffic";
  if (dut.unit == run.show.engine().top)  // its frames are not to be had from a file
    return fmt::format("racebeam verify {} --replay all{} -o again", word, run_text);
  const std::string replay = fmt::format("racebeam verify {} --replay {}{}", word, file, run_text);
  if (captured.empty()) return replay;
  return fmt::format("racebeam capture {} {}{} -o {} && {}", dut.unit, captured, run_text, file,
                     replay);
}

UnitVerdict replayed(const Replay& what, TrafficSource& source,
                     const std::function<void(std::uint64_t)>& compared) {
  UnitVerdict verdict{what.dut.unit, what.traffic, 0, 0, 0, 0, {}, {}};
  for (const PortTraffic::Port& port : source.head().ports) verdict.masked += !port.input;
  const auto start = std::chrono::steady_clock::now();
  try {
    const Json done = Json::parse(forked([&] {
      const auto player = player_of(what, source.head());
      try {
        const ReplayDone end = replay(source, *player, compared);
        return Json{{"clocks", end.clocks},
                    {"difference", end.difference ? Json(*end.difference) : Json()}}
            .dump();
      } catch (const RtlFault& fault) {
        return Json{{"fault", fault.what()}}.dump();
      }
    }));
    if (done.contains("fault")) {
      verdict.fault = done["fault"];
      return verdict;
    }
    verdict.clocks = done["clocks"];
    verdict.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (done["difference"].is_null()) return verdict;
    const std::uint64_t clock = done["difference"];
    const Json window = Json::parse(forked([&] {
      const auto player = player_of(what, source.head());
      const ReplayWindow around = replay_window(source, *player, clock);
      if (around.first.port.empty())
        throw RtlError(
            fmt::format("{} differed in clock {}, and does not when it is run again: "
                        "its outputs follow from more than its inputs",
                        what.dut.unit, clock));
      verdict.differences = around.differences;
      verdict.clocks = around.clocks;
      verdict.first = first_of(what, source, around.first);
      return to_json(verdict).dump();
    }));
    return verdict_of(window);
  } catch (const ChildDied& death) {
    verdict.fault = death.what();
  }
  return verdict;
}

Replay replay_of(const VerifyOptions& options, const Run& run, const std::string& word,
                 const TrafficHead* head) {
  const std::string unit = word.substr(0, word.find('='));
  const std::string as_model = unit + "=" + ModelPlayer;
  const UseOption use = use_of(run);
  unit_choices choices;
  const bool whole = unit == run.show.engine().top;
  if (whole &&
      (options.replay != AllFrames || word == as_model || &run.show.engine() != &beam_engine()))
    throw UsageError(
        unit +
        " is put to a frame through back doors, not through its pins: replay "
        "one of its units" +
        (&run.show.engine() == &beam_engine() ? ", or it with --replay all" : std::string()));
  if (!whole) use.use(choices, as_model);  // there is such a unit
  if (head) expect_traffic(options.replay, *head, run, unit);
  Replay what{
      options,
      run,
      word,
      {unit, word == as_model ? ModelPlayer : "", run.k, run.show.tables(), run.show.frames()},
      options.folder};
  if (options.replay == AllFrames && !whole && word.find('=') != std::string::npos)
    what.gates = use.gate_bits(unit, word.substr(word.find('=') + 1));
  if (what.gates.empty()) verilate(what);
  return what;
}

void verilate(Replay& what) {
  if (!what.dut.plugin.empty()) return;
  const UseOption use = use_of(what.run);
  unit_choices choices;
  use.lockstep(choices, what.word);
  what.dut.plugin = what.word == what.run.show.engine().top ? use.whole_chip(deposited_registers())
                                                            : choices.of(what.dut.unit).plugin;
}

int verify_replay(const VerifyOptions& options) {
  if (options.replay == AllFrames) return verify_all_frames(options);
  if (options.units.size() != 1 || options.units.front() == AllUnits)
    throw UsageError("--replay is for one unit: name the one whose traffic it is");
  if (options.frames != VerifyOptions::UsualFrames)
    throw UsageError("--replay has its frames from the file; leave out --frames");
  TrafficFile file(options.replay);
  const Run run = open_run(options, true);
  try_folder(options.folder);
  const Replay what = replay_of(options, run, options.units.front(), &file.head());
  catch_interrupts();
  Progress progress(static_cast<std::int64_t>(file.clocks()), "clocks");
  const UnitVerdict verdict = replayed(what, file, [&](std::uint64_t clocks) {
    progress.draw(static_cast<std::int64_t>(clocks), clocks, what.dut.unit);
  });
  progress.clear();
  return tell_verdicts({verdict}, options.seed, options.json);
}

}  // namespace racebeam
