// Which inputs of RTL reach no output without a register between, as yosys reads it.
//
// Who simulates a unit among others need not evaluate it when such an input moves: it counts at the
// next edge. What is not known is taken to reach an output.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

/// Names of all inputs that have no combinational path to any output; kept in the cache. None, if
/// there is no yosys, it does not read the RTL, the RTL has several files, or it asks whether yosys
/// or a synthesis reads it, since a simulator has another answer. Throws RtlError, Interrupted.
std::set<std::string> quiet_inputs(const RtlSources& sources);

/// The same of the JSON that `scripts/netlist --paths` writes. Throws RtlError if it is none.
std::set<std::string> quiet_inputs_in(const std::string& json);

}  // namespace racebeam
