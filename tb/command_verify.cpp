// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/command_verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "tb/console.h"
#include "tb/errors.h"
#include "tb/forked.h"
#include "tb/interrupt.h"
#include "tb/lockstep_report.h"
#include "tb/open_show.h"
#include "tb/progress.h"
#include "tb/set_knob.h"
#include "tb/signal_bench.h"
#include "tb/use_option.h"
#include "tb/verify_unit.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Row = "{:<18} {:<7} {:>12} {:>12} {:>10}\n";

bool all_differ(const SignalBench& bench) {
  const auto units = bench.locksteps();
  return std::all_of(units.begin(), units.end(), [](auto* unit) { return unit->first(); });
}

/// The knobs as they were set, for a command that repeats a run.
std::string set_text(const VerifyOptions& options) {
  std::string text;
  for (const std::string& assignment : options.assignments) text += " --set " + assignment;
  return text;
}

/// All units at once, in the chip, over frames spread over the show, until each has differed.
std::vector<UnitVerdict> verify_in_chip(const VerifyOptions& options, const Show& show,
                                        const knobs& k, const unit_choices& choices) {
  const auto start = std::chrono::steady_clock::now();
  SignalBench bench({k, false, false, false, show.program(), choices});
  std::vector<int> frames;
  Progress progress(static_cast<int>(options.frames));
  for (int i = 0; i < options.frames && !interrupted() && !all_differ(bench); ++i) {
    frames.push_back(static_cast<int>(i * show.frames() / options.frames));
    bench.seek(frames.back());
    bench.render();
    progress.draw(i + 1, bench.clocks());
  }
  progress.clear();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<UnitVerdict> verdicts;
  for (const Lockstep* unit : bench.locksteps()) {
    UnitVerdict verdict{unit->unit(), "chip", unit->clocks(), unit->differences(), seconds, {}};
    if (const auto& d = unit->first()) {
      const Raster raster(k.clocks_per_pixel, k.speed);
      const BeamPlace place = place_of(d->clock, frames, raster);
      const std::string repeat =
          fmt::format("racebeam render {} --first {} --use {}=lockstep{}", options.scene,
                      place.frame, unit->unit(), set_text(options));
      verdict.first = FirstDifference{d->port, d->clock, d->expected,
                                      d->got,  place,    explain(*d, frames, raster, repeat)};
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

UnitVerdict verify_at_random(const VerifyOptions& options, const UnitUnderTest& dut) {
  UnitVerdict verdict = verify_unit(dut, static_cast<std::uint64_t>(options.random),
                                    static_cast<unsigned>(options.seed));
  if (verdict.first)
    verdict.first->text +=
        fmt::format("\nrepeat: racebeam verify {} --scene {} --frames 0 --random {} --seed {}{}\n",
                    dut.unit, options.scene, options.random, options.seed, set_text(options));
  return verdict;
}

Json to_json(const FirstDifference& d) {
  Json json = {{"port", d.port}, {"clock", d.clock}, {"expected", d.expected}, {"got", d.got}};
  if (d.place)
    json["place"] = {{"frame", d.place->frame}, {"line", d.place->line}, {"clock", d.place->clock}};
  json["text"] = d.text;
  return json;
}

Json to_json(const UnitVerdict& v) {
  return {{"unit", v.unit},
          {"traffic", v.traffic},
          {"clocks", v.clocks},
          {"seconds", v.seconds},
          {"differences", v.differences},
          {"first", v.first ? to_json(*v.first) : Json()}};
}

UnitVerdict from_json(const Json& json) {
  UnitVerdict verdict{json["unit"],        json["traffic"], json["clocks"],
                      json["differences"], json["seconds"], {}};
  if (const Json& d = json["first"]; !d.is_null())
    verdict.first = FirstDifference{d["port"], d["clock"], d["expected"], d["got"], {}, d["text"]};
  return verdict;
}

std::string row(const UnitVerdict& v) {
  const double speed = v.seconds > 0 ? static_cast<double>(v.clocks) / v.seconds / 1e6 : 0;
  return fmt::format(Row, v.unit, v.traffic, v.clocks, v.differences, fmt::format("{:.2f}", speed));
}

}  // namespace

int command_verify(const VerifyOptions& options) {
  const Show show = open_show(options.scene);
  if (options.frames < 0 || options.frames > show.frames())
    throw UsageError(fmt::format("--frames {} is out of range; the scene has {}", options.frames,
                                 show.frames()));
  knobs k = show.standard_knobs();
  for (const std::string& assignment : options.assignments) set_knob(k, assignment);
  if (const std::string why = show.objection(k); !why.empty()) throw UsageError(why);
  const UseOption use(k, show.program());
  unit_choices choices;
  if (options.units.empty()) use.lockstep(choices, "all");
  for (const std::string& unit : options.units) use.lockstep(choices, unit);
  catch_interrupts();
  std::vector<UnitVerdict> verdicts;
  // SystemC elaborates once in a process: each unit on random traffic has a process of its own.
  for (const auto& [unit, choice] : choices.by_unit) {
    if (options.random <= 0 || interrupted()) break;
    const std::string text = forked([&, name = unit, plugin = choice.plugin] {
      try {
        return to_json(verify_at_random(options, {name, plugin, k, show.program()})).dump();
      } catch (const RtlError& error) {
        return Json{{"refused", error.what()}}.dump();
      }
    });
    const Json answer = Json::parse(text);
    if (answer.contains("refused")) throw RtlError(answer["refused"]);
    verdicts.push_back(from_json(answer));
  }
  if (options.frames > 0 && !interrupted())
    for (const UnitVerdict& verdict : verify_in_chip(options, show, k, choices))
      verdicts.push_back(verdict);

  bool differs = false;
  Json json = Json::array();
  for (const UnitVerdict& verdict : verdicts) {
    differs |= verdict.differences > 0;
    json.push_back(to_json(verdict));
  }
  if (options.json) {
    print(
        Json{{"schema", "racebeam-verify"}, {"version", 1}, {"seed", options.seed}, {"units", json}}
            .dump(2) +
        "\n");
  } else {
    print(fmt::format(Row, "unit", "traffic", "clocks", "differ", "M clocks/s"));
    for (const UnitVerdict& verdict : verdicts) print(row(verdict));
  }
  for (const UnitVerdict& verdict : verdicts)
    if (verdict.first) tell(verdict.unit + ", " + verdict.traffic + ":\n" + verdict.first->text);
  if (interrupted()) return ExitInterrupted;
  return differs ? ExitDifference : ExitGood;
}

}  // namespace racebeam
