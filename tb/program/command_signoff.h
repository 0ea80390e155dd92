// `racebeam signoff`: is "no difference" of a unit to be believed? Each check of each unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

Command signoff_row();

}  // namespace racebeam
