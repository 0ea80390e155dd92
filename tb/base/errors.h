// How the program ends: its exit codes, and the errors that lead to them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace racebeam {

enum ExitCode {
  ExitGood = 0,
  ExitDifference = 1,  ///< a check found a difference
  ExitUsage = 2,       ///< bad input or usage, or a file that cannot be written
  ExitMissing = 3,     ///< something is missing on the machine
  ExitInterrupted = 130,
  ExitPipe = 141,  ///< nobody reads what it prints, as a command that SIGPIPE ends
};

/// The caller asked for something that does not exist; says what to do instead. Exit code 2.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine lacks something; says how to get it. Exit code 3.
class MissingTool : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The pins of a chip break the video mode, or have none; says frame, line, clock, what was seen
/// and what must be there.
class SyncError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Ctrl-C or the like has come while something else was waited for. Exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace racebeam
