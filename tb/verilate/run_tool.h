// Other programs, run without a shell: Verilator, the compiler, yosys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace racebeam {

struct ToolRun {
  std::vector<std::string> words;        ///< the program, found in PATH, and its arguments
  std::string folder;                    ///< where it runs; empty: here
  std::vector<std::string> environment;  ///< "NAME=value", beside what is there
  std::function<void()> tick;            ///< called some ten times a second meanwhile
  /// How long processors may work for each process of it, which is killed then; 0: no limit.
  std::chrono::seconds work{0};
};

struct ToolResult {
  bool good;          ///< it ended with 0
  std::string said;   ///< on stdout and stderr
  bool late = false;  ///< it took too long, and was ended
};

/// Runs it to its end, in a process group of its own, which dies when the program is interrupted.
/// Throws MissingTool if there is no such program, Interrupted.
ToolResult run_tool(const ToolRun& run);

/// Runs several, `jobs` at once, each for `limit` at most, and calls `done` with a run's number
/// when it has ended. When that throws, the others are ended. Throws as run_tool() does.
void run_tools(const std::vector<ToolRun>& runs, int jobs, std::chrono::milliseconds limit,
               const std::function<void(std::size_t, const ToolResult&)>& done);

/// Whether PATH has such a program.
bool has_tool(const std::string& name);

}  // namespace racebeam
