// What the model of a unit, or of a whole chip, says from power-up on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tb/twin/port_traffic.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// Whether it is engine::top.
bool is_whole_chip(const UnitUnderTest& dut);

/// `usual`; a whole chip shows little before its first frame is over, and gets that.
std::uint64_t clocks_from_reset(const UnitUnderTest& dut, std::uint64_t usual);

/// Random traffic of a unit as record_from_reset() has it; the pins of a whole chip that draws its
/// first frames. The first clock is in reset. Nothing else of SystemC may happen in the process.
/// Throws Interrupted.
PortTraffic traffic_from_reset(const UnitUnderTest& dut, std::uint64_t clocks, unsigned seed);

}  // namespace racebeam
