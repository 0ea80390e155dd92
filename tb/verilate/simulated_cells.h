// What a netlist of yosys lacks for a simulation in a unit's place.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

/// The netlist with ports and registers, whose names do not begin with '_', marked for Verilator.
std::string with_marked_registers(const std::string& netlist);

/// The netlist of a module whose ports are bits, in a module of its name with the ports of
/// `syntax`.
std::string behind_whole_ports(const std::string& netlist, const RtlSyntax& syntax);

/// Modules of the standard cells of osu018, with the functions of its library's file. Throws
/// RtlError with what yosys says, MissingTool, Interrupted.
std::string osu018_functions();

}  // namespace racebeam
