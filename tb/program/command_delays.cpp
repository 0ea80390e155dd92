// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_delays.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/judge/delay_run.h"
#include "tb/program/common_options.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr int MostLatency = 32;

struct Options : RunOptions {
  std::string output;  ///< of `new`; empty: stdout
  std::string at;      ///< a list of frames
  long long frames = 0;
  long long most = 8;
  std::vector<std::string> channels;  ///< empty: all that may be delayed
  long long jobs = 1;
  bool json = false;
};

int delays_new(const Options& options) {
  const engine& built = options.engine.empty() ? *engines().front() : engine_named(options.engine);
  const std::string text = delays_template(built);
  if (options.output.empty()) {
    print(text);
    return ExitGood;
  }
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(options.output, ignored)))
    throw UsageError(options.output + " exists; choose another name, or remove it first");
  write_text(options.output, text);
  tell("wrote " + options.output);
  return ExitGood;
}

Json to_json(const ChannelSlack& slack, bool races_beam) {
  Json rows = Json::array();
  for (std::size_t latency = 0; latency < slack.by_latency.size(); ++latency) {
    const DelayedPictures& one = slack.by_latency[latency];
    rows.push_back({{"latency", latency}, {"clocks", one.clocks}});
    if (races_beam) rows.back()["starved_pixels"] = one.starved;
    rows.back()["other_pixels"] = one.pixels;
  }
  Json json = {{"channel", slack.channel}, {"by_latency", rows}};
  if (races_beam) json["starving_slack"] = slack.starving_slack();
  json["colour_slack"] = slack.colour_slack();
  return json;
}

std::string slack_text(int slack, int most) {
  return slack == most ? fmt::format("{} or more", slack) : std::to_string(slack);
}

std::string table_of(const std::vector<ChannelSlack>& all, const engine& built, std::size_t count,
                     int most) {
  const bool races = built.races_beam;
  std::string text = fmt::format(
      "{:<10} {:>7} {:>14} {}{:>13}\n", "channel", "latency", races ? "busy clocks" : "clocks",
      races ? fmt::format("{:>15} ", "starved pixels") : "", "other pixels");
  for (const ChannelSlack& slack : all)
    for (std::size_t latency = 0; latency < slack.by_latency.size(); ++latency) {
      const DelayedPictures& one = slack.by_latency[latency];
      text += fmt::format("{:<10} {:>7} {:>14} {}{:>13}\n", slack.channel, latency, one.clocks,
                          races ? fmt::format("{:>15} ", one.starved) : "", one.pixels);
    }
  text += fmt::format("\nin sum over {} {}{}; a channel bears so many clocks:\n", count,
                      races ? "frame" : "picture", count == 1 ? "" : "s");
  for (const ChannelSlack& slack : all) {
    text += fmt::format("{:<10}", slack.channel);
    if (races)
      text +=
          fmt::format(" {} until more pixels starve,", slack_text(slack.starving_slack(), most));
    text += fmt::format(" {} until a pixel has another colour\n",
                        slack_text(slack.colour_slack(), most));
  }
  for (const ChannelRow& row : channels_of(built))
    if (!row.may_delay()) text += fmt::format("{:<10} 0: {}\n", row.name, row.why_delay());
  return text;
}

int delays_run(const Options& options) {
  Run run = open_run(options, true);
  const engine& built = run.show.engine();
  std::vector<std::string> channels = options.channels;
  for (const std::string& name : channels) delayed_channel(built, name, 1);
  if (channels.empty())
    for (const ChannelRow& row : channels_of(built))
      if (row.may_delay()) channels.emplace_back(row.name);
  const std::vector<int> numbers = spread_numbers(options.at, options.frames, run.show);
  use_units(run, options.units, false, false);
  catch_interrupts();
  const int most = static_cast<int>(options.most);
  Progress progress(static_cast<std::int64_t>(channels.size()) * most + 1, "runs");
  std::vector<ChannelSlack> all;
  try {
    all = measure_slack(run, channels, numbers, most, static_cast<int>(options.jobs),
                        [&](int done) { progress.draw(done, 0); });
  } catch (const std::exception&) {
    if (interrupted()) return ExitInterrupted;  // a child says so in words
    throw;
  }
  progress.clear();
  if (!options.json) {
    print(table_of(all, built, numbers.size(), most));
    return ExitGood;
  }
  Json json = Json::array();
  for (const ChannelSlack& slack : all) json.push_back(to_json(slack, built.races_beam));
  print(Json{{"schema", "racebeam-delays"},
             {"version", 1},
             {"scene", run.show.name()},
             {"numbers", numbers},
             {"channels", json}}
            .dump(2) +
        "\n");
  return ExitGood;
}

void add_run(const CommandOptions& run, Options& options) {
  run.add_option("scene", options.scene, "demo, or a scene file").type_name("SCENE").required();
  run.add_option("--at", options.at, "Frames or pictures, such as 7223, or 5,700-720,3900")
      .type_name("FRAMES")
      .check(not_empty);
  add_number(run, "--frames", options.frames,
             "So many, spread over the scene, instead; 3, or 1 of an engine that does not race "
             "the beam",
             is_number("--frames", FramesRange));
  add_number(run, "--max", options.most, "Up to so many clocks of latency",
             is_number_in("--max", 1, MostLatency))
      .capture_default_str();
  run.add_option("--channel", options.channels, "This channel only; repeatable")
      .type_name("CHANNEL")
      .repeatable();
  options.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  add_number(run, "--jobs", options.jobs, "Processes at once; default: the cores",
             is_number_in("--jobs", 1, 256));
  add_run_options(run, options);
  run.add_option("--use", options.units, "Put RTL in a unit's place, as in render; repeatable")
      .type_name("UNIT=IMPLEMENTATION")
      .repeatable();
  run.add_flag("--json", options.json, "JSON on stdout instead of text");
}

}  // namespace

Command delays_row() {
  return {"delays", "Put registers between the units; what each channel bears", "Change",
          "delays run demo --frames 1", [](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<Options>();
            const auto chosen = std::make_shared<int (*)(const Options&)>();
            const auto add = [&](const char* name, const char* help, int (*run)(const Options&)) {
              return command.add_subcommand(name, help, [chosen, run] { *chosen = run; });
            };
            const CommandOptions fresh =
                add("new", "Write a file for --delays, with all channels", delays_new);
            add_engine_option(fresh, options->engine, "Channels of this engine");
            fresh.add_option("-o,--output", options->output, "Default: stdout")
                .type_name("F.toml")
                .check(not_empty);
            add_run(add("run", "Measure each channel with 0, 1, ... clocks", delays_run), *options);
            return
                [options, chosen](const std::vector<std::string>&) { return (*chosen)(*options); };
          }};
}

}  // namespace racebeam
