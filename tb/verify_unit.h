// Model and RTL of one unit on random traffic, in lockstep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "sc/scene_program.h"
#include "tb/lockstep.h"

namespace racebeam {

/// What a comparison of one unit found.
struct UnitVerdict {
  std::string unit, traffic;  ///< traffic: "chip" or "random"
  std::uint64_t clocks = 0, differences = 0;
  double seconds = 0;
  std::string first;  ///< the first difference explained; empty if there is none
};

/// A unit and what its twins are made for.
struct UnitUnderTest {
  std::string unit, plugin;  ///< plugin: empty for the unit's own RTL
  knobs k;
  const scene_program* program;  ///< for timeline and scene_rom
};

/// Compares model and RTL over `clocks` clocks of RandomTraffic. Only one such comparison and
/// nothing else of SystemC may happen in a process. Throws RtlError.
UnitVerdict verify_unit(const UnitUnderTest& dut, std::uint64_t clocks, unsigned seed);

}  // namespace racebeam
