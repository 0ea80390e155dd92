// What some port has in all clocks in which model and RTL differ, as in "only while full_o is 1".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/twin/lockstep.h"

namespace racebeam {

/// "only while ack_o is 1: ..." of the port for which that is least likely by chance; empty if it
/// could be chance for all of them.
std::string difference_condition(const LockstepDifference& difference);

}  // namespace racebeam
