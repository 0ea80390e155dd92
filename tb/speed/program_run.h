// A run of this program as a user starts it, and what it costs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct ProgramRun {
  std::string out;         ///< what it said on stdout
  double seconds = 0;      ///< until it had ended
  double cpu_seconds = 0;  ///< of it and all processes that it waited for
  double megabytes = 0;    ///< in memory at most, of the largest of them
};

/// Throws std::runtime_error if it does not end well.
ProgramRun run_program(const std::vector<std::string>& words);

}  // namespace racebeam
