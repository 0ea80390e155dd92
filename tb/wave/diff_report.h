// What `racebeam trace --diff` says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/wave/selection.h"

namespace racebeam {

/// Compares two dumps and prints their first difference. `selection` chooses the signals;
/// `shared_only`: signals and times that one of them has not are no difference. Returns the exit
/// code. Throws UsageError: no dump, nothing shared.
int report_diff(const std::string& a_path, const std::string& b_path, bool shared_only,
                const TraceSelection& selection);

}  // namespace racebeam
