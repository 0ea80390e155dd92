// The knobs as RTL knows them: parameters of a unit's module.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/knobs.h"
#include "sc/swap/rtl_parameters.h"

namespace racebeam {

/// The same chip with the knobs that are input pins as they are by default: no RTL has them as
/// parameters.
knobs without_pins(knobs k);

/// One for each knob: interval_stack_depth is IntervalStackDepth.
std::vector<rtl_parameter> knob_parameters(const knobs& k);

}  // namespace racebeam
