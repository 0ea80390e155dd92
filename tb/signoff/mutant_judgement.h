// What the fates of a unit's mutants, and the waivers, come to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "tb/signoff/mutant_fate.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/signoff_unit.h"

namespace racebeam {

/// A file of streams, "" if there is none, and where it would be part of the stimulus.
struct Episodes {
  std::string file, place;
};

/// Bad: one has escaped, is undecided without a waiver, or is still alive; a waiver is of no use;
/// more than 1 % are waived. `episodes`: that find those which have escaped.
CheckResult judge_mutants(const std::string& unit, const MutantNetlist& netlist,
                          const std::map<int, MutantFate>& fates, const SignoffOptions& options,
                          const Episodes& episodes);

}  // namespace racebeam
