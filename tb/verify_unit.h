// Model and RTL of one unit on random traffic, in lockstep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/lockstep.h"

namespace racebeam {

/// What a comparison of one unit found.
struct UnitVerdict {
  std::string unit, traffic;  ///< traffic: "chip" or "random"
  std::uint64_t clocks = 0, differences = 0;
  double seconds = 0;
  std::string first;  ///< the first difference explained; empty if there is none
};

/// Compares model and RTL of `unit` over `clocks` clocks of RandomTraffic. `plugin`: empty for the
/// unit's own RTL. Only one such comparison and nothing else of SystemC may happen in a process.
/// Throws RtlError.
UnitVerdict verify_unit(const std::string& unit, const std::string& plugin, std::uint64_t clocks,
                        unsigned seed);

}  // namespace racebeam
