// A command of the program: a row of the table in command_table.cpp.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tb/program/command_options.h"

namespace racebeam {

/// Does what the command line asks for; the exit code. `words`: all of it, program name first.
using RunCommand = std::function<int(const std::vector<std::string>& words)>;

struct Command {
  std::string name, summary;
  std::string group;    ///< in the help
  std::string example;  ///< a command line without the program's name
  /// Adds the options; what it returns keeps what they are read into.
  std::function<RunCommand(const CommandOptions& command)> add;
};

/// A command that is run with its options alone.
template <class Options>
Command make_command(const char* name, const char* summary, const char* group, const char* example,
                     void (*add)(const CommandOptions&, Options&), int (*run)(const Options&)) {
  return {name, summary, group, example, [add, run](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<Options>();
            add(command, *options);
            return [options, run](const std::vector<std::string>&) { return run(*options); };
          }};
}

/// All of them, as the help lists them.
const std::vector<Command>& command_table();

}  // namespace racebeam
