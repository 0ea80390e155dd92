// The levels that a chip is simulated at, as they are named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

constexpr const char* LevelTlm = "tlm";
constexpr const char* LevelSignal = "signal";

}  // namespace racebeam
