// Units in RTL as one module: what rtl_island loads.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/verilate/comb_paths.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

struct IslandUnit {
  std::string unit, instance;
  std::vector<std::string> parameters;  ///< "Name=value", as on Verilator's command line
  bool back_door;                       ///< it can have clocks and inputs of its own
  RtlSyntax syntax;
  CombGroups groups = {};  ///< of its ports
};

/// Whether an output of one of them is an input of another one, among which `units` it connects:
/// groups of numbers, those of one unit left out.
std::vector<std::vector<std::size_t>> islands_among(const std::vector<IslandUnit>& units);

/// The module IslandTop: inputs groupN_NAME_i and outputs NAME_o for the wires that they read and
/// drive, late_NAME_i where it reaches no output before the next edge, joined by name, as the units
/// of a chip are. All use nothing but rising edges of their clock.
/// Throws RtlError: two widths of one wire.
std::string island_text(const std::vector<IslandUnit>& units);

}  // namespace racebeam
