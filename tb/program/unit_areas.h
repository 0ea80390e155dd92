// What the units of an engine are as gates of osu018: flip-flops, cells, area and slack.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/verilate/gate_timing.h"

namespace racebeam {

struct UnitArea {
  std::string unit;
  GateNetlist netlist;
  GateTiming timing;
};

/// Of the units named, or of all that show the built-in demo and of the whole chip. Gates are made
/// if need be. Throws UsageError for a unit that there is not, RtlError, MissingTool, Interrupted.
std::vector<UnitArea> areas_of(const engine& of, const std::vector<std::string>& units);

std::string area_table(const std::vector<UnitArea>& areas);
std::string area_json(const engine& of, const std::vector<UnitArea>& areas);

}  // namespace racebeam
