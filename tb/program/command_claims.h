// racebeam claims: what the article says, measured.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

Command claims_row();

}  // namespace racebeam
