// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/yosys.h"

#include <chrono>
#include <filesystem>

#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr auto VersionLimit = std::chrono::seconds(60);

}  // namespace

std::string recipe_file(const std::string& script) {
  std::error_code error;
  const std::string file = project_folder() + "/scripts/" + script;
  if (!std::filesystem::exists(file, error))
    throw MissingTool("racebeam is installed without its RTL: there is no " + file +
                      "; `cmake --install BUILD --component rtl` adds it");
  return file;
}

std::string yosys_version() {
  if (!has_tool("yosys")) throw MissingTool("yosys is not installed; install the package `yosys`");
  ToolResult answer{};
  run_tools({{{"yosys", "-V"}, "", {}, {}}}, 1, VersionLimit,
            [&answer](std::size_t, const ToolResult& result) { answer = result; });
  const std::string line = answer.said.substr(0, answer.said.find('\n'));
  if (answer.late) throw MissingTool("yosys does not answer; does `yosys -V` end?");
  if (!answer.good || line.rfind("Yosys ", 0) != 0)
    throw MissingTool("yosys does not say its version: " + line);
  return line;
}

std::string osu018_cells() {
  const std::string file = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib";
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw MissingTool("there is no " + file + "; install the package `qflow-tech-osu018`");
  return file;
}

}  // namespace racebeam
