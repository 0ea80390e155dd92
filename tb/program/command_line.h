// The command line: which command, with which options.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command_text.h"

namespace racebeam {

/// Runs the command. Returns its exit code; throws what the command throws, and UsageError for a
/// command line that cannot be understood.
int run_command_line(int argc, char** argv);

/// Reads a command line, without the program's name, and runs nothing. Throws UsageError as
/// run_command_line() does.
void check_command_line(const std::string& words);

/// The program with all that a command line may say.
CommandText program_text();

}  // namespace racebeam
