// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
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

/// In lines that fit.
class Help : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    return help_entry(make_option_name(option, is_positional) + make_option_opts(option),
                      make_option_desc(option), get_column_width());
  }
  std::string make_subcommand(const CLI::App* command) const override {
    return help_entry(command->get_name(), command->get_description(), get_column_width());
  }
};

OptionText text_of(const CLI::Option& option, bool is_help) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  const Help help;
  return {names,
          help.make_option_name(&option, names.empty()),
          help.make_option_opts(&option),
          help.make_option_desc(&option),
          option.get_type_name(),
          option.get_items_expected_min(),
          option.get_items_expected_max(),
          is_help};
}

CommandText text_of(const CLI::App& app) {
  CommandText all{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options())
    all.options.push_back(text_of(*option, option == app.get_help_ptr()));
  for (const CLI::App* command : app.get_subcommands(nullptr))
    all.commands.push_back(text_of(*command));
  return all;
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

/// The program, ready to read.
class Reader {
 public:
  Reader()
      : app_("A SystemC model of a chip that ray-traces just ahead of a VGA beam.", ProgramName) {
    app_.set_version_flag("--version", ProgramName + (std::string(" ") + program_version()));
    app_.require_subcommand(1);
    app_.formatter(std::make_shared<Help>());  // of the commands too, which are added later
    app_.footer(ExitCodes);
    app_.add_flag_callback(
        "--man", [this] { said_ = man_page(text()), throw CLI::Success(); },
        "Print the manual page: racebeam --man | man -l -");
    app_.add_option_function<std::string>(
            "--completion",
            [this](const std::string& shell) {
              said_ = completion_script(shell), throw CLI::Success();
            },
            "Print a script with which bash, fish or zsh completes command lines")
        ->type_name("SHELL");
    for (const Command& row : command_table()) {
      CLI::App* command = app_.add_subcommand(row.name, row.summary);
      command->group(row.group);
      command->footer(fmt::format("Example:\n  {} {}\n\n{}", ProgramName, row.example, ExitCodes));
      runs_.push_back(row.add(CommandOptions(*command)));
    }
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  CommandText text() const { return text_of(app_); }

  /// Lets CLI11 read. False if that is all, and `say` to be printed. Throws UsageError.
  bool read(const std::function<void(CLI::App&)>& parse, std::string& say) {
    try {
      parse(app_);
      return true;
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() != 0) throw usage_error(app_, error);
      std::ostringstream help, unused;
      app_.exit(error, help, unused);
      say = help.str() + said_;
      return false;
    }
  }

  /// The command that was read.
  const RunCommand& chosen() const {
    std::size_t row = 0;
    while (!app_.got_subcommand(command_table().at(row).name)) ++row;
    return runs_[row];
  }

 private:
  CLI::App app_;
  std::vector<RunCommand> runs_;  // by row of the table
  std::string said_;              // by an option that stands for a command
};

}  // namespace

int run_command_line(int argc, char** argv) {
  Reader reader;
  if (argc > 1 && std::string(argv[1]) == CompleteOption) {
    print(completions(reader.text(), {argv + 2, argv + argc}));
    return ExitGood;
  }
  std::string say;
  if (!reader.read([&](CLI::App& app) { app.parse(argc, argv); }, say)) {
    print(say);
    return ExitGood;
  }
  std::vector<std::string> words(argv, argv + argc);
  words.front() = ProgramName;
  return reader.chosen()(words);
}

void check_command_line(const std::string& words) {
  std::string unused;
  Reader().read([&](CLI::App& app) { app.parse(words); }, unused);
}

CommandText program_text() { return Reader().text(); }

}  // namespace racebeam
