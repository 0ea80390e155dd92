// A circuit and a mutant of it, copied side by side into a third one, with one gate where they have
// the same. yosys-abc may be asked gate by gate whether two that seem to differ are the same:
// behind a multiplier it does not find that a difference has ended before it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"

namespace racebeam {

/// Outputs of the two; and where the two differ in each gate through which all differences of
/// outputs go, the first one first: where one of these is 0, all outputs are equal.
struct SideBySide {
  std::vector<Literal> unit, mutant;
  std::vector<Literal> changed{};
};

/// Of two circuits without registers, for those values of their inputs. Gates are compared with
/// those of the same number, if there are as many. Until `end` yosys-abc is asked of gates that
/// have been equal in samples. Throws MissingTool, Interrupted.
SideBySide copy_side_by_side(AndCircuit& into, const AndCircuit& unit, const AndCircuit& mutant,
                             const std::vector<Literal>& unit_values,
                             const std::vector<Literal>& mutant_values, WorkClock::time_point end);

}  // namespace racebeam
