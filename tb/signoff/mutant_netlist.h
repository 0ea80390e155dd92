// The netlist of a unit's RTL, and one with many mutants in it, of which an input chooses one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

/// The input that chooses a mutant by its number; 0: none.
constexpr const char* MutantInput = "racebeam_mutant";

/// One small change, as yosys says it.
struct Mutant {
  int number;           ///< 1 is the first
  std::string command;  ///< of yosys, but for the input
  std::string name;     ///< "inv $procmux$85 Y[5]"
  std::string source;   ///< "stacks.sv:64.11-64.30 ...", or ""
};

struct MutantNetlist {
  std::string rtlil;            ///< of the unit alone: words, flattened, no mutant in it
  std::string asserted;         ///< the same with its assertions; "": none that yosys can read
  std::string verilog;          ///< of all mutants
  std::vector<Mutant> mutants;  ///< no two alike
};

/// Makes them with yosys, `most` mutants, or all that it can think of if there are fewer. What was
/// made before is in the cache. Throws RtlError with what yosys says, MissingTool, Interrupted.
MutantNetlist mutant_netlist(const RtlSources& sources, int most, unsigned seed);

/// How wide MutantInput has to be.
int mutant_bits(const std::vector<Mutant>& mutants);
/// Commands of yosys that put all of them into the unit, each chosen by its number.
std::string choosing_commands(const std::vector<Mutant>& mutants, int bits);

}  // namespace racebeam
