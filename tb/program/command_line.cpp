// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/base/version.h"
#include "tb/program/command.h"
#include "tb/program/completion.h"
#include "tb/program/completion_script.h"
#include "tb/program/help_text.h"
#include "tb/program/man_page.h"

namespace racebeam {

namespace {

constexpr const char* ProgramName = "racebeam";
constexpr const char* ExitCodes =
    "Exit codes: 0 good, 1 a check found a difference, 2 bad usage or input, 3 something is\n"
    "missing on the machine, 130 interrupted, 141 nobody reads the output.";

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
  app.footer(ExitCodes);
  std::string text;  // instead of a command
  app.add_flag_callback(
      "--man", [&] { text = man_page(app), throw CLI::Success(); },
      "Print the manual page: racebeam --man | man -l -");
  app.add_option_function<std::string>(
         "--completion",
         [&](const std::string& shell) { text = completion_script(shell), throw CLI::Success(); },
         "Print a script with which bash, fish or zsh completes command lines")
      ->type_name("SHELL");
  std::vector<RunCommand> runs;
  for (const Command& row : command_table()) {
    CLI::App* command = app.add_subcommand(row.name, row.summary);
    command->group(row.group);
    command->footer(fmt::format("Example:\n  {} {}\n\n{}", ProgramName, row.example, ExitCodes));
    runs.push_back(row.add(*command));
  }
  if (argc > 1 && std::string(argv[1]) == CompleteOption) {
    print(completions(app, {argv + 2, argv + argc}));
    return ExitGood;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw usage_error(app, error);
    std::ostringstream help, unused;
    app.exit(error, help, unused);
    print(help.str() + text);
    return ExitGood;
  }
  std::vector<std::string> words(argv, argv + argc);
  words.front() = ProgramName;
  std::size_t chosen = 0;
  while (!app.got_subcommand(command_table().at(chosen).name)) ++chosen;
  return runs[chosen](words);
}

}  // namespace racebeam
