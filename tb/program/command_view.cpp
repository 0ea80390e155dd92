// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_view.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/project_folder.h"
#include "tb/program/common_options.h"
#include "tb/program/view_setting.h"
#include "tb/program/view_tt.h"
#include "tb/show/open_show.h"
#include "tb/view/sources.h"

namespace racebeam {

namespace {

constexpr const char* BuiltIn = "demo";

Stage stage_of(Run run, const std::vector<std::string>& units) {
  const SourceKind& kind = source_of(run.show.engine(), run.level);
  use_units(run, units);
  return {run.show, kind.make(run)};
}

/// SystemC wires a chip once in a process: another scene needs another process.
struct StartAgain {};

// The keys that make this state out of the one at the start.
std::string keys_of(const ViewState& state) {
  std::string keys;
  for (const auto& [key, on] :
       {std::pair{"b", !state.beam}, std::pair{"i", state.borders}, std::pair{"g", state.gauges},
        std::pair{"t", state.text}, std::pair{"h", state.help}, std::pair{"m", state.muted}})
    if (on) keys += std::string(key) + " ";
  if (state.map) keys += std::to_string(1 + static_cast<int>(*state.map)) + " ";
  for (int i = 0; i < std::abs(state.speed); ++i) keys += state.speed < 0 ? "- " : "+ ";
  return keys;
}

// The same command at the same frame. Does not return.
void start_again(const ViewOptions& options, const Viewer& viewer) {
  const int frame = std::min(viewer.source().watch().frame(), viewer.show().frames() - 1);
  std::vector<std::string> words = {"racebeam",
                                    "view",
                                    options.scene,
                                    "--level",
                                    LevelSignal,
                                    "--first",
                                    std::to_string(frame),
                                    "--scale",
                                    std::to_string(options.scale),
                                    "--output",
                                    options.folder};
  for (const std::string& one : options.assignments) words.insert(words.end(), {"--set", one});
  for (const std::string& one : options.units) words.insert(words.end(), {"--use", one});
  if (options.frames) words.insert(words.end(), {"--frames", std::to_string(*options.frames)});
  if (options.terminal) words.emplace_back("--term");
  if (viewer.control.state.paused) words.emplace_back("--paused");
  const std::string keys = keys_of(viewer.control.state);
  if (!keys.empty()) words.push_back("--keys=" + keys);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  give_back_stdout();
  execv("/proc/self/exe", arguments.data());
  throw UsageError("the program cannot be started again with the changed scene");
}

// The demo as a scene file: free flight needs one.
Show demo_file() { return open_show(project_folder() + "/scenes/demo.toml"); }

std::string explain_of(const ViewOptions& options) {
  const bool plain = options.scene.find_first_of(" '\"\\$`&;()<>|*?[]#~!") == std::string::npos;
  return "explain " + (plain ? options.scene : "'" + options.scene + "'") + options.set_text();
}

}  // namespace

int command_view(const ViewOptions& options) {
  if (!options.project.empty()) return view_tt(options);
  refuse_tt_options(options);
  if (options.scene.empty())
    throw UsageError("scene is required, or --tt; `racebeam view --help` shows what it takes");
  const Run run = open_run(options);
  const bool rooms = run.show.of_rooms();
  const std::vector<std::string> keys =
      keys_to_press(options, source_of(run.show.engine(), run.level).keys);
  Viewer::Options setting = viewer_options(options, run.show.frames());
  if (rooms && options.scene != BuiltIn) setting.scene_file = scene_path(options.scene);
  setting.demo_file = demo_file;
  setting.explain = explain_of(options);
  setting.restage = [&](const Show& changed) {
    Run again{changed, run.level, knobs_of(changed, options.assignments)};  // or the old goes on
    if (run.level != LevelTlm) throw StartAgain{};
    return stage_of(std::move(again), {});
  };
  Stage stage = stage_of(run, options.units);
  auto screen = open_screen(options);
  Viewer viewer(std::move(stage), setting);
  viewer.control.state.paused = options.paused;
  catch_interrupts();
  bool again = false;
  int code = ExitGood;
  try {
    code = run_view(viewer, *screen, keys);
  } catch (const StartAgain&) {
    again = true;
  } catch (const Interrupted&) {
    code = ExitInterrupted;
  }
  screen.reset();
  if (const std::string said = viewer.end(); !said.empty()) tell(said);
  if (again) start_again(options, viewer);
  return code;
}

namespace {

void add_options(const CommandOptions& command, ViewOptions& options) {
  command.add_option("scene", options.scene, "demo, or a scene file").type_name("SCENE");
  add_number(command, "--first", options.first, "First frame", is_number("--first", FirstRange))
      .capture_default_str();
  add_number(command, "--frames", options.frames, "End after so many frames, and leave out none",
             is_number("--frames", "1 or more"));
  command
      .add_option("--level", options.level,
                  "tlm: the cores in one loop; signal: SystemC units wired at 50.4 MHz, at their "
                  "own speed; tlm without --use")
      .type_name("LEVEL")
      .check(not_empty);
  add_run_options(command, options);
  command.add_option("--use", options.units, "Put RTL in a unit's place, as in render; repeatable")
      .type_name("UNIT=IMPLEMENTATION")
      .repeatable();
  add_tt_options(command, options);
  command
      .add_option("--sound-pin", options.sound_pin,
                  "With --tt: the pin of uio_out that is heard, 0..7; 7")
      .type_name("N");
  command
      .add_option("--record-inputs", options.record_inputs,
                  "With --tt: write the inputs, those of the keys too, for --inputs")
      .type_name("FILE.csv")
      .check(not_empty);
  command.add_option("-o,--output", options.folder, "Folder for screenshots and GIFs")
      .type_name("DIR")
      .check(not_empty)
      .capture_default_str();
  command.add_option("--keys", options.keys, "Keys to press, one after each picture: \"1 g t o\"")
      .type_name("NAMES");
  add_number(command, "--scale", options.scale, "Size of a pixel, 1..8; 0: as large as fits well",
             is_number("--scale", "0..8"))
      .capture_default_str();
  command.add_flag(
      "--term", options.terminal,
      "In this terminal, in 24-bit colours, instead of a window; with --frames also as "
      "text into a file");
  command.add_flag("--paused", options.paused, "Start with the first frame, and wait for keys");
}

}  // namespace

Command view_row() {
  return make_command<ViewOptions>("view", "Watch a scene in a window, with sound (F1: keys)",
                                   "See", "view demo --first 5000", add_options, command_view);
}

}  // namespace racebeam
