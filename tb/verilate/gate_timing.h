// The longest path of gates of osu018, by scripts/timing: OpenSTA, before layout, without wires.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/base/constants.h"
#include "tb/verilate/gate_netlist.h"

namespace racebeam {

/// What the clock of the chips leaves for a path: 50.4 MHz.
constexpr double ClockNanoseconds = 1e9 / (2 * PixelClockHz);

struct GateTiming {
  double ns;  ///< of the longest path from a register or input pin to a register or output pin
  std::string from, to;

  double slack() const { return ClockNanoseconds - ns; }
};

/// Of a netlist of `unit` in osu018. A netlist with a cell that the library has not is no faster
/// for that: throws RtlError with what OpenSTA says, MissingTool, Interrupted.
GateTiming gate_timing(const std::string& unit, const GateNetlist& netlist);

}  // namespace racebeam
