// Other programs, run without a shell: Verilator, the compiler.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace racebeam {

struct ToolRun {
  std::vector<std::string> words;        ///< the program, found in PATH, and its arguments
  std::string folder;                    ///< where it runs; empty: here
  std::vector<std::string> environment;  ///< "NAME=value", beside what is there
  std::function<void()> tick;            ///< called some ten times a second meanwhile
};

struct ToolResult {
  bool good;         ///< it ended with 0
  std::string said;  ///< on stdout and stderr
};

/// Runs it to its end, in a process group of its own, which dies when the program is interrupted.
/// Throws MissingTool if there is no such program, Interrupted.
ToolResult run_tool(const ToolRun& run);

/// Whether PATH has such a program.
bool has_tool(const std::string& name);

}  // namespace racebeam
