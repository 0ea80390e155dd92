// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/gate_timing.h"

#include <chrono>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

namespace {

constexpr auto Limit = std::chrono::minutes(10);

}  // namespace

GateTiming gate_timing(const std::string& unit, const GateNetlist& netlist) {
  osu018_cells();
  if (!has_tool("sta")) throw MissingTool("sta is not installed; install the package `opensta`");
  const WorkFolder work;
  ToolResult result{};
  run_tools({{{recipe_file("timing"), "osu018", unit, "--netlist", netlist.file, "--pins"},
              work.path(),
              {"TMPDIR=" + work.path()},
              {}}},
            1, Limit, [&result](std::size_t, const ToolResult& end) { result = end; });
  if (result.late) throw RtlError("sta did not end with " + netlist.file);
  std::istringstream words(result.said);
  std::string name, flip_flops, cells, area, multipliers;
  GateTiming timing{};
  words >> name >> flip_flops >> cells >> area >> multipliers >> timing.ns >> timing.from >>
      timing.to;
  if (!result.good || !words || name != unit || timing.ns <= 0)
    throw RtlError("there is no longest path of " + netlist.file + ":\n" + result.said);
  return timing;
}

}  // namespace racebeam
