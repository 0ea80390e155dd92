// What yosys-abc is asked about a clock of a unit and of a mutant beside it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/always_zero.h"
#include "tb/signoff/reached_pairs.h"
#include "tb/signoff/state_values.h"

namespace racebeam {

/// A unit and a mutant, with the same inputs and registers, and what is known of the two.
struct StepQuestion {
  const AndCircuit &unit, &mutant;  ///< if there is a wide word, the last register is its mark
  const StateValues& possible;
  const ReachedPairs& reached;
  const RegisterWord& wide;

  /// Whether no clock leads out of that, from states where the unit's word has that value; or else
  /// from where one does: inputs of the unit, its registers, and values for registers of the mutant
  /// that are free. Until `swept_until` gates are compared one by one, too. Without a limit only
  /// what is found at once. Throws MissingTool, Interrupted.
  ZeroAnswer ask(unsigned value, WorkClock::time_point swept_until,
                 std::chrono::seconds limit) const;
};

}  // namespace racebeam
