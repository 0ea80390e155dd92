// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_shake.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/judge/shake_run.h"
#include "tb/program/common_options.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* HeldBack = "clocks_per_pixel";
constexpr int Slowest = 8;
/// A restart after an overflow of it does not bear to wait (docs/stalls.md).
constexpr const char* Overflows = "interval_stack_depth";
constexpr int Deep = 16;

/// Of an engine that races the beam the beam is held back, unless --set says how much.
Run held_back(const ShakeCommandOptions& options, bool& held) {
  RunOptions run = options;
  const auto sets = [](const std::string& text) { return text.rfind(HeldBack, 0) == 0; };
  Run plain = open_run(run, true);
  held = plain.show.engine().races_beam &&
         std::none_of(run.assignments.begin(), run.assignments.end(), sets);
  if (!held) return plain;
  run.assignments.push_back(fmt::format("{}={}", HeldBack, Slowest));
  return open_run(run, true);
}

int list_channels(const ShakeCommandOptions& options) {
  const engine& built =
      options.engine.empty()
          ? (options.scene.empty() ? *engines().front() : open_show(options.scene).engine())
          : engine_named(options.engine);
  constexpr const char* Row = "{:<10} {:<18} {:<18} {:<28} {}\n";
  Json json = Json::array();
  std::string may = fmt::format(Row, "channel", "from", "to", "signals", "may stall, as");
  std::string may_not = fmt::format(Row, "channel", "from", "to", "signals", "may not stall, as");
  for (const ChannelRow& row : channels_of(built)) {
    (row.may_stall() ? may : may_not) +=
        fmt::format(Row, row.name, row.from, row.to, row.signals, row.why);
    json.push_back({{"name", row.name},
                    {"from", row.from},
                    {"to", row.to},
                    {"signals", row.signals},
                    {"may_stall", row.may_stall()},
                    {"why", row.why}});
  }
  if (options.json)
    print(Json{{"schema", "racebeam-channels"},
               {"version", 1},
               {"engine", built.name},
               {"channels", json}}
              .dump(2) +
          "\n");
  else print(may + "\n" + may_not);
  return ExitGood;
}

Json to_json(const ShakenPicture& picture) {
  Json json = {{"seed", picture.seed},
               {"number", picture.number},
               {"stalled_clocks", picture.stalled},
               {"starved_pixels", picture.starved},
               {"pixels", picture.pixels}};
  if (picture.pixels > 0)
    json["first"] = {
        {"x", picture.x}, {"y", picture.y}, {"expected", picture.expected}, {"got", picture.got}};
  return json;
}

/// The command that shows one picture again.
std::string repeat_text(const ShakeCommandOptions& options, const stall_plan& plan,
                        const ShakenPicture& picture) {
  std::string text =
      fmt::format("racebeam shake {} --at {} --seeds 1 --shake {},{},{}", options.scene,
                  picture.number, picture.seed, plan.begin, plan.go_on);
  for (const std::string& channel : options.stalls) text += " --stall " + channel;
  for (const std::string& unit : options.units) text += " --use " + unit;
  return text + options.set_text();
}

bool may_overflow(const Run& run) {
  const auto& rows = run.show.engine().knobs;
  return std::any_of(rows.begin(), rows.end(),
                     [](const knob_row& row) { return row.name == std::string(Overflows); }) &&
         run.k.of(Overflows) < Deep;
}

std::string difference_text(const ShakeCommandOptions& options, const Run& run,
                            const stall_plan& plan, const ShakenPicture& picture,
                            const char* what) {
  std::string text = fmt::format(
      "{} {}, seed {}: {} pixels have another colour with stalls, the first at ({}, {}): {:#x} "
      "instead of {:#x}",
      what, picture.number, picture.seed, picture.pixels, picture.x, picture.y, picture.got,
      picture.expected);
  if (picture.starved > 0)
    text += fmt::format(
        "\n{} pixels or intervals starved: if the units are right, they need more time: fewer "
        "stalls, or a slower beam (--set {}={})",
        picture.starved, HeldBack, Slowest);
  else if (may_overflow(run))
    text += fmt::format(
        "\nif the units are right, it may be a restart that had to wait, which is another picture: "
        "--set {}={} has none",
        Overflows, Deep);
  return text + "\nagain: " + repeat_text(options, plan, picture);
}

}  // namespace

int command_shake(const ShakeCommandOptions& options) {
  if (options.channels) return list_channels(options);
  if (options.scene.empty())
    throw UsageError("scene is required; `racebeam shake --help` shows what it takes");
  if (options.shake.empty()) throw UsageError("--shake needs a seed");
  bool held = false;
  Run run = held_back(options, held);
  const auto plan = stall_plan_of(run.show.engine(), options);
  const std::vector<int> numbers = spread_numbers(options.at, options.frames, run.show);
  use_units(run, options.units, false, false);
  leave_out_whole_chip(run.show.engine(), options, options.units, run.units);
  catch_interrupts();
  const char* const what = run.show.engine().races_beam ? "frame" : "picture";
  ShakeRun shaken(run, plan);
  std::vector<ShakenPicture> pictures;
  Json json = Json::array(), left_out = Json::array();
  std::uint64_t differing = 0, stalled = 0;
  std::vector<int> judged;
  Progress progress(static_cast<std::int64_t>(numbers.size()) * (options.seeds + 1));
  try {
    int done = 0;
    for (const int number : numbers) {
      const std::string objection = shaken.objection(number);
      progress.draw(++done, shaken.clocks());
      if (objection.empty()) {
        judged.push_back(number);
        continue;
      }
      left_out.push_back({{"number", number}, {"why", objection}});
      progress.clear();
      tell(fmt::format("{} {} is left out: {}", what, number, objection));
    }
    for (long long n = 0; n < options.seeds && !interrupted(); ++n)
      for (const int number : judged) {
        const ShakenPicture picture =
            shaken.shake(plan->seed + static_cast<std::uint64_t>(n), number);
        progress.draw(++done, shaken.clocks());
        stalled += picture.stalled;
        differing += picture.pixels;
        json.push_back(to_json(picture));
        pictures.push_back(picture);
      }
  } catch (const Interrupted&) {
  }
  progress.clear();
  if (options.json)
    print(Json{{"schema", "racebeam-shake"},
               {"version", 1},
               {"begin", plan->begin},
               {"go_on", plan->go_on},
               {"left_out", left_out},
               {"pictures", json}}
              .dump(2) +
          "\n");
  else
    print(fmt::format("{} seeds x {} {}s, {} clocks with a stall{}: {} colours differ\n",
                      options.seeds, judged.size(), what, stalled,
                      held ? fmt::format(", {}={}", HeldBack, Slowest) : "", differing));
  for (const ShakenPicture& picture : pictures)
    if (picture.pixels > 0) {
      tell_difference(difference_text(options, run, *plan, picture, what));
      break;
    }
  if (interrupted()) return ExitInterrupted;
  if (judged.empty())
    throw UsageError(fmt::format("none of these {}s can be judged; choose others: --at", what));
  return differing > 0 ? ExitDifference : ExitGood;
}

namespace {

constexpr long long MostSeeds = 1000000;

void add_options(const CommandOptions& command, ShakeCommandOptions& options) {
  command.add_option("scene", options.scene, "demo, or a scene file").type_name("SCENE");
  add_shake_options(command, options);
  add_number(command, "--seeds", options.seeds, "So many seeds, from that of --shake on",
             is_number_in("--seeds", 1, MostSeeds))
      .capture_default_str();
  add_number(command, "--frames", options.frames,
             "Frames or pictures, spread over the scene; 3, or 1 of an engine that does not race "
             "the beam",
             is_number("--frames", FramesRange));
  command.add_option("--at", options.at, "These, in this order, instead: 7223, or 5,700-720,3900")
      .type_name("FRAMES")
      .check(not_empty);
  add_run_options(command, options);
  command
      .add_option("--use", options.units,
                  "Put RTL in a unit's place, as in render; with stalls and without; repeatable")
      .type_name("UNIT=IMPLEMENTATION")
      .repeatable();
  command.add_flag("--channels", options.channels, "List what may stall, and what may not");
  command.add_flag("--json", options.json, "JSON on stdout instead of text");
}

}  // namespace

Command shake_row() {
  return make_command<ShakeCommandOptions>(
      "shake", "Stall the handshakes between units; every colour must stay", "Verify",
      "shake demo --seeds 2", add_options, command_shake);
}

}  // namespace racebeam
