// `racebeam verify --power-up`: a unit's RTL from many values of its registers at power-up.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/verify_unit.h"
#include "tb/twin/power_up.h"

namespace racebeam {

/// As a row of verify: traffic "power-up", the starts that differ, and the registers behind them.
UnitVerdict verify_power_up(const UnitUnderTest& dut, const PowerUpOptions& options,
                            const std::string& repeat);

/// What the findings say, a line each: registers without reset with the port that they reach.
std::string power_up_story(const std::string& unit, const PowerUpFindings& findings);

}  // namespace racebeam
