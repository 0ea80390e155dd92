// Sign-off of gates: are they the unit, and what do they cost?
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/signoff/check_result.h"
#include "tb/twin/unit_under_test.h"
#include "tb/verilate/gate_netlist.h"

namespace racebeam {

struct GatesOptions {
  std::uint64_t clocks = 20'000;  ///< of traffic_from_reset(), at least 2
  unsigned seed = 1;
  std::vector<std::string> kinds = gate_kinds();
  std::string file = {};   ///< RTL that becomes the gates; empty: the unit's own
  double least_slack = 0;  ///< nanoseconds at 50.4 MHz, before layout
};

/// Traffic of the model goes into the gates of each kind, whose outputs must be the model's; then
/// wrong bits are put into it, which must be found: it does compare. Of osu018 also flip-flops,
/// cells, area and slack. Without yosys, cells or OpenSTA, and when interrupted: Undecided. Only
/// one such check and nothing else of SystemC may happen in a process. Throws UsageError.
CheckResult sign_off_gates(const UnitUnderTest& dut, const GatesOptions& options);

}  // namespace racebeam
