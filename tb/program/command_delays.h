// `racebeam delays`: registers in the channels between units, and how many each bears.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

Command delays_row();

}  // namespace racebeam
