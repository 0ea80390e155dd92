// Which functions of verilated RTL need not be called at a tick, since nothing that they read has
// changed in it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/direct_steps.h"

namespace racebeam {

/// Of the text of all classes, and that of the header of Vrtl___024root: what combinational logic
/// made of its inputs and registers holds until one of them changes. So a step of some size that
/// has no state is called at a tick only if a step before it has changed one of few registers, or
/// has been called in turn. What is not understood is called always.
void find_needless(const std::string& classes, const std::string& header, DirectSteps& steps);

}  // namespace racebeam
