// What the headers of our units leave without reset though a port shows it: a reviewed list.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct Unreset {
  std::string unit;
  /// Of a register or of an instance with all of its registers, as a path without indices; of an
  /// output; or of an input that is called a reset and resets nothing.
  std::string name;
  const char* reason;  ///< field `Reset` of the header
};

/// Whether the row says so of a register "u_lane[2].sum_q[7]", or of a port.
bool is_named(const Unreset& row, const std::string& name);
/// Registers that are the same wherever others are random: at power-up, and after the reset. Of an
/// engine::top those of its units, each behind the unit's path.
std::vector<Unreset> contract_registers(const std::string& unit);
/// Outputs that are not compared, as they show registers that are loaded, not reset.
std::vector<Unreset> contract_ports(const std::string& unit);
/// Why; empty if it is no such register or port.
std::string contract_reason(const std::string& unit, const std::string& name);

}  // namespace racebeam
