// Does the stimulus of `racebeam verify` find mistakes? It is tried with as many small ones as
// yosys can put into the RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/signoff/signoff_unit.h"

namespace racebeam {

/// Good if each mutant is found by the stimulus, proved equal, or waived, and at most 1 % are
/// waived. What is known stays in `options.folder`, and the next call goes on from there. Throws
/// RtlError, MissingTool, Interrupted.
CheckResult sign_off_mutants(const SignoffUnit& unit, const SignoffOptions& options);

}  // namespace racebeam
