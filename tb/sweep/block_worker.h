// What `racebeam sweep work` does: a block of a plan, on whichever machine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// Does what nobody has answered of a block, and appends it to results. The exit code: 1 if some
/// work cannot be done. Throws UsageError if there is no such block, or the plan is for another
/// model; OutputError.
int work_on_block(const std::string& folder, int rung, int block);

}  // namespace racebeam
