// How yosys gets the RTL of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

/// How yosys reads a unit: the commands up to a flat netlist of words, with its assertions if that
/// is asked for. They work in a folder that link_sources() has filled.
std::string reading_commands(const RtlSources& sources, bool assertions = false);
/// Links to the project's RTL, to the files of `sources` and to the folders that are searched:
/// names of cells come from paths, and shall be the same wherever the RTL lies.
void link_sources(const RtlSources& sources, const std::string& folder);

/// Runs yosys in a folder. Throws RtlError with what it says, MissingTool, Interrupted.
void run_yosys(const std::string& commands, const std::string& folder, const std::string& unit);

}  // namespace racebeam
