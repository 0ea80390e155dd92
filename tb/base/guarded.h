// What ends the program early: every error as a message and an exit code.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace racebeam {

/// What `work` returns, or the exit code of what it throws, which is told on stderr.
int guarded(const std::function<int()>& work);

}  // namespace racebeam
