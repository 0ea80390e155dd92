// What a user is told of RTL that is used nevertheless.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/swap/rtl_model.h"

namespace racebeam {

/// Registers on the falling edge of the clock.
void warn_of_falling_edges(const rtl_model& model);

/// Signals that depend on themselves without a register between.
void warn_of_circular_logic(const rtl_model& model);

}  // namespace racebeam
