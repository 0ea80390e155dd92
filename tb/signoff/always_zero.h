// Whether the output of a circuit can ever be 1, asked of yosys-abc.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <vector>

#include "tb/signoff/aiger.h"

namespace racebeam {

/// Neither is told if it is not known.
struct ZeroAnswer {
  bool zero = false;         ///< it is 0 for all inputs
  std::vector<bool> inputs;  ///< for which it is 1; or none
};

/// Of a circuit without registers and with one output. Throws MissingTool, Interrupted.
ZeroAnswer always_zero(const AndCircuit& circuit, std::chrono::seconds limit);
/// What is found at once, or else not known.
ZeroAnswer zero_at_once(const AndCircuit& circuit);

}  // namespace racebeam
