// The longest path of gates of osu018, by scripts/timing: OpenSTA, before layout, without wires.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/verilate/gate_netlist.h"

namespace racebeam {

struct GateTiming {
  double ns;  ///< of the longest path from a register or input pin to a register or output pin; 0
              ///< if nothing but constants is left of the unit
  double period;  ///< ns that the engine's clock leaves for it
  std::string from, to;
  std::vector<std::string> excepted;  ///< modules with exceptions, MODULE.sdc beside their RTL

  double slack() const { return period - ns; }
  double megahertz() const { return 1000 / period; }
};

/// Of a netlist of `unit` in osu018, for the clock of `of` with its standard knobs. An excepted
/// path, of several clocks, is as long as what it leaves for the last of them. A netlist with a
/// cell that the library has not is no faster for that: throws RtlError with what OpenSTA says,
/// MissingTool, Interrupted.
GateTiming gate_timing(const engine& of, const std::string& unit, const GateNetlist& netlist);

}  // namespace racebeam
