// Verilator's warnings of a unit's RTL, all of them: none may be left.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/signoff/signoff_unit.h"

namespace racebeam {

/// As `scripts/lint` does. Throws MissingTool, Interrupted.
CheckResult sign_off_lint(const SignoffUnit& unit, const SignoffOptions& options);

}  // namespace racebeam
