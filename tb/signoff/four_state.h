// A unit's netlist in four states: what is unknown at power-up, and where it goes.
//
// yosys makes the netlist (scripts/netlist), Icarus Verilog runs recorded traffic into it. Before
// the first clock, in reset, all registers are x. A pin that is x later shows what may be unknown:
// gates are more careful than logic, x & ~x is x. That a pin depends on nothing unknown is certain.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/twin/port_traffic.h"
#include "tb/twin/power_up.h"

namespace racebeam {

struct FourStateFindings {
  struct Pin {
    std::string port;
    std::uint64_t clock;  ///< the first one in which it is unknown
  };
  std::vector<Pin> pins;
  std::vector<std::string> registers;  ///< of the netlist, unknown after the clock in reset
};

/// The RTL of `plugin` as words, with its parameters. `known`: registers that are 0 at power-up,
/// as paths "u_MODULE.name", or instances "u_MODULE", whose registers all are. `open`: those of
/// them that have a value of their own after the clock in reset.
/// Throws MissingTool, RtlError with what yosys or Icarus says.
FourStateFindings run_in_four_states(const std::string& plugin, const PortTraffic& traffic,
                                     const std::vector<std::string>& known,
                                     const std::vector<OpenRegister>& open);

}  // namespace racebeam
