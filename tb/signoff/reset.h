// The reset of a unit: what it does not reach, and whether a pin shows it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/signoff/check_result.h"
#include "tb/twin/power_up.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

struct ResetOptions {
  PowerUpOptions starts{};                 ///< 100 random values of the registers, and ones
  std::uint64_t four_state_clocks = 2000;  ///< of the netlist; 0: not run
};

/// Random values at power-up in the RTL, and x in its netlist. Bad: an output depends on them after
/// the reset, that contract_registers.h does not name, or a register named there reaches no
/// output. Undecided: a tool is missing, or a pin is unknown in four states and no value
/// of the registers was found that shows there. Runs in a process of its own.
CheckResult sign_off_reset(const UnitUnderTest& dut, const ResetOptions& options);

}  // namespace racebeam
