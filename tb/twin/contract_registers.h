// What the headers of our units leave without reset though a port shows it: a reviewed list.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct Unreset {
  const char* unit;
  const char* name;    ///< of a register, or of an output
  const char* reason;  ///< field `Reset` of the header
};

/// Registers that are 0 at power-up wherever others are random.
std::vector<Unreset> contract_registers(const std::string& unit);
/// Outputs that are not compared, as they show registers that are loaded, not reset.
std::vector<Unreset> contract_ports(const std::string& unit);
/// Why; empty if it is no such register or output.
std::string contract_reason(const std::string& unit, const std::string& name);

}  // namespace racebeam
