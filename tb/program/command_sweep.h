// `racebeam sweep`: many points of the knobs, measured, compared and kept.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

Command sweep_row();

}  // namespace racebeam
