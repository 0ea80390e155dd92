// What follows in verilated RTL from its clock and its inputs, so that its classes need not be
// asked.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace racebeam {

/// A function of the class, Vrtl___024root___FUNCTION().
struct DirectStep {
  std::string function;
  bool at_tick = false;  ///< called when the clock of a clock_wrapper() or an island rises
  std::set<int> groups;  ///< and when one of these is taken
  /// If not, at a tick only if one of these members has changed in it, or one of these functions
  /// has been called.
  bool always = true;
  std::vector<std::string> changed{}, called{};
};

struct DirectSteps {
  std::vector<std::string> inputs;    ///< functions that are called first if others have moved
  std::vector<DirectStep> registers;  ///< then these, in this order
};

/// Of classes of Verilator 5 in a folder: Vrtl___024root___eval() looks five times which triggers
/// there are, and calls what follows from inputs and from triggers. Who knows which trigger there
/// is can call that. A clock of a unit in an island, which also rises by a tick of its own, rises
/// with the island's. None if there are other triggers, such as a clock that the RTL makes, or if
/// the classes look otherwise.
std::optional<DirectSteps> direct_steps(const std::string& folder);

}  // namespace racebeam
