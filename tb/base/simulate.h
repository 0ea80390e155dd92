// sc_start() that ends as the RTL in the simulation ends.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <systemc>

namespace racebeam {

/// Runs the kernel. Throws RtlFault, as thrown in a process of the kernel.
void simulate(const sc_core::sc_time& time);

}  // namespace racebeam
