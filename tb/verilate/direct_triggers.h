// What makes registers of verilated RTL change, so that whoever makes it need not be asked.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace racebeam {

/// The numbers of Verilator's triggers.
struct DirectTriggers {
  /// The clock of a clock_wrapper() or an island rises, and with it those that units of an island
  /// have, which also rise by ticks of their own.
  std::vector<int> ticks;
  int take = -1;  ///< Take changes; -1: there is none
};

/// Of classes of Verilator 5 in a folder: Vrtl___024root___eval() looks five times which triggers
/// there are, and what follows from inputs is in eval_ico, from triggers in eval_nba. Who knows
/// which trigger there is can call the two. None if there are other triggers, such as a clock that
/// the RTL makes, or if the classes look otherwise.
std::optional<DirectTriggers> direct_triggers(const std::string& folder);

}  // namespace racebeam
