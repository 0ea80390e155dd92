// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_line.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/nearest.h"
#include "tb/base/version.h"
#include "tb/program/command_bench.h"
#include "tb/program/command_doctor.h"
#include "tb/program/command_explain.h"
#include "tb/program/command_knobs.h"
#include "tb/program/command_options.h"
#include "tb/program/command_render.h"
#include "tb/program/command_scene.h"
#include "tb/program/command_trace.h"
#include "tb/program/command_verify.h"
#include "tb/program/command_verilate.h"
#include "tb/program/command_view.h"
#include "tb/program/help_text.h"
#include "tb/program/verify_watch.h"

namespace racebeam {

namespace {

constexpr const char* ProgramName = "racebeam";

int run_scene(const CLI::App& app, const SceneOptions& options) {
  const std::string command = app.get_subcommands().front()->get_name();
  if (command == "check") return command_scene_check(options);
  if (command == "show") return command_scene_show(options);
  if (command == "plan") return command_scene_plan(options);
  if (command == "notes") return command_scene_notes(options);
  return command_scene_new(options);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11's error in words that say what to do.
UsageError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* chosen = &app;
  std::string name = ProgramName;
  while (!chosen->get_subcommands().empty()) {
    chosen = chosen->get_subcommands().front();
    name += " " + chosen->get_name();
  }
  const CLI::App& command = *chosen;
  const std::vector<std::string> rest = app.remaining(true);
  const std::string first = rest.empty() ? "" : rest.front();
  if (first.size() > 1 && first[0] == '-')
    return unknown_name("option", first.substr(0, first.find('=')), option_names(command));
  std::vector<std::string> known;
  for (const CLI::App* one : command.get_subcommands(nullptr)) known.push_back(one->get_name());
  if (!known.empty()) {
    return first.empty() ? UsageError("a command is missing; `" + name + " --help` lists them")
                         : unknown_name("command", first, known);
  }
  const std::string help = "; `" + name + " --help` shows what it takes";
  if (!first.empty()) return UsageError("'" + first + "' is one argument too many" + help);
  return UsageError(error.what() + help);
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app("A SystemC model of a chip that ray-traces just ahead of a VGA beam.", ProgramName);
  app.set_version_flag("--version", ProgramName + (std::string(" ") + program_version()));
  app.require_subcommand(1);
  app.formatter(std::make_shared<HelpText>());  // of the commands too, which are added later
  app.footer(
      "Exit codes: 0 good, 1 a check found a difference, 2 bad usage or input, 3 something is\n"
      "missing on the machine, 130 interrupted, 141 nobody reads the output.");
  RenderOptions render;
  BenchOptions bench;
  VerifyOptions verify;
  VerilateOptions verilate;
  SceneOptions scene;
  ViewOptions view;
  ExplainOptions explain;
  TraceOptions trace;
  bool json = false;
  add_render(app, render);
  app.add_subcommand("knobs", "List what --set may change")
      ->add_flag("--json", json, "JSON on stdout instead of the table");
  add_bench(app, bench);
  add_verify(app, verify);
  add_verilate(app, verilate);
  add_scene(app, scene);
  add_view(app, view);
  add_explain(app, explain);
  add_trace(app, trace);
  app.add_subcommand("doctor", "Check the machine and list versions")
      ->add_flag("--json", json, "JSON on stdout instead of the text");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw usage_error(app, error);
    std::ostringstream help, unused;
    app.exit(error, help, unused);
    print(help.str());
    return ExitGood;
  }
  if (app.got_subcommand("knobs")) return command_knobs(json);
  if (app.got_subcommand("doctor")) return command_doctor(json);
  if (app.got_subcommand("verify"))
    return verify.watch ? verify_watch(verify) : command_verify(verify);
  if (app.got_subcommand("verilate")) return command_verilate(verilate);
  if (app.got_subcommand("view")) return command_view(view);
  if (app.got_subcommand("explain")) return command_explain(explain);
  if (app.got_subcommand("trace")) return command_trace(trace);
  if (app.got_subcommand("bench")) return command_bench(bench);
  if (app.got_subcommand("scene")) return run_scene(*app.get_subcommand("scene"), scene);
  render.command.assign(argv, argv + argc);
  render.command.front() = ProgramName;
  return command_render(render);
}

}  // namespace racebeam
