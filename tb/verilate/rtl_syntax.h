// What RTL says of itself, as Verilator understands it: ports, parameters, and what deserves a
// word.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

struct RtlSyntax {
  /// Something at a line of a file, whose path is absolute.
  struct Place {
    std::string file;
    int line = 0;
    std::string name;
  };
  struct Port {
    std::string name, direction;  ///< direction: "input", "output" or "inout"
    int bits = 1;
    Place place;  ///< named TOP.NAME
  };
  struct Parameter {
    std::string name, value;  ///< value: of a whole number in decimal, of others empty
  };

  Place top;                       ///< the module
  std::vector<std::string> files;  ///< all that were read, includes too
  std::vector<Port> ports;
  std::vector<Parameter> parameters;  ///< of the top module, in order
  std::string clock;                  ///< its input clk_i or clk; empty: it has none
  /// Nothing but rising edges of the clock is used, nowhere its level.
  bool rising_only = false;
  /// Something is printed, or asserted, elsewhere than at an edge: as inputs move.
  bool speaks_between_edges = false;
  /// Something lies elsewhere than in registers: random numbers, time, files, queues, processes.
  bool state_elsewhere = false;
  std::vector<Place> falling;  ///< registers on the falling edge of the clock
  std::vector<Place> loops;    ///< loops that are not counted by a constant
  /// What reaches beyond the simulation: "$system", "$c", "$fopen", "$writememh", "`systemc_...",
  /// and functions without a body, such as those of DPI; of packages and classes too.
  std::vector<Place> calls;
  /// $readmemh and $readmemb, by the file that they name; empty: it is only known in the run.
  std::vector<Place> reads;
};

/// Elaborates the RTL, without making a plug-in. Throws RtlError with what Verilator says,
/// MissingTool, Interrupted.
RtlSyntax read_rtl_syntax(const RtlSources& sources);

}  // namespace racebeam
