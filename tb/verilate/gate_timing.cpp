// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/gate_timing.h"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

#include "sc/base/constants.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

namespace {

constexpr auto Limit = std::chrono::minutes(10);

}  // namespace

GateTiming gate_timing(const engine& of, const std::string& unit, const GateNetlist& netlist) {
  osu018_cells();
  if (!has_tool("sta")) throw MissingTool("sta is not installed; install the package `opensta`");
  const WorkFolder work;
  GateTiming timing{};
  timing.period = 1e9 / (of.video(of.standard(nullptr)).clocks_per_pixel * double{PixelClockHz});
  if (netlist.cells == 0) return {0, timing.period, "-", "-", {}};
  ToolResult result{};
  run_tools({{{recipe_file("timing"), "osu018", unit, "--netlist", netlist.file, "--pins",
               "--period", fmt::format("{:.4f}", timing.period)},
              work.path(),
              {"TMPDIR=" + work.path()},
              {}}},
            1, Limit, [&result](std::size_t, const ToolResult& end) { result = end; });
  if (result.late) throw RtlError("sta did not end with " + netlist.file);
  std::istringstream words(result.said);
  std::string name, flip_flops, cells, area, multipliers;
  words >> name >> flip_flops >> cells >> area >> multipliers >> timing.ns >> timing.from >>
      timing.to;
  if (!result.good || !words || name != unit || timing.ns <= 0)
    throw RtlError("there is no longest path of " + netlist.file + ":\n" + result.said);
  for (std::string module; words >> module;) timing.excepted.push_back(module);
  return timing;
}

}  // namespace racebeam
