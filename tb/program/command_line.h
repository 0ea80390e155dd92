// The command line: which command, with which options.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Runs the command. Returns its exit code; throws what the command throws, and UsageError for a
/// command line that cannot be understood.
int run_command_line(int argc, char** argv);

}  // namespace racebeam
