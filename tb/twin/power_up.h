// What a unit's outputs owe to the values that its registers have at power-up.
//
// The traffic begins with one clock in reset. The RTL runs it many times, its registers random
// before; after the reset every output shall be the model's. Registers that the reset does not
// reach are found by name: one alone is random, all others are 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tb/twin/port_traffic.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

struct PowerUpOptions {
  int seeds = 100;
  std::uint64_t clocks = 10000;  ///< of traffic, for each
  unsigned traffic = 1;          ///< seed of the traffic
  /// Look for where each register shows that the reset does not reach. Else only if from some start
  /// an output differs: each takes a dozen times the clocks.
  bool one_by_one = true;
};

/// An output that is not the model's after the reset.
struct PowerUpDifference {
  std::string start;  ///< "zeros", "ones", "seed 7"
  std::string port;
  std::uint64_t clock = 0, expected = 0, got = 0;
};

/// A register that after the reset still has what it had at power-up.
struct UnresetRegister {
  std::string name;
  int bits = 0;             ///< of an array: of all elements
  std::string port;         ///< that it reaches; empty: none was seen, or not looked for
  std::uint64_t clock = 0;  ///< when
  std::string reason;       ///< of contract_reason() of it or of the port; empty: a fault
};

struct PowerUpFindings {
  bool has_reset = false;  ///< has an input that resets
  int starts = 0;          ///< zeros, ones, and the seeds
  std::uint64_t clocks = 0;
  int registers = 0;                           ///< with names; arrays count once
  std::vector<PowerUpDifference> differences;  ///< the first one of each start
  std::vector<UnresetRegister> unreset;
  std::string fault;  ///< what ended the RTL; or empty
};

/// A register, or an element of an array, that the contract leaves without reset.
struct OpenRegister {
  std::string name;  ///< as the RTL has it: "u_lane[2].sum_q[7]"
  int bits;
  std::uint64_t value;  ///< after the clock in reset, where all registers were 0 at power-up
};
/// Those of RTL with the signals inside. Throws RtlError, RtlFault.
std::vector<OpenRegister> open_registers(const std::string& plugin, const PortTraffic& traffic);

/// `plugin`: RTL of the unit, with the signals inside. Of a unit without a reset only the number of
/// its registers. Throws RtlError.
PowerUpFindings find_power_up(const std::string& plugin, const PortTraffic& traffic,
                              const PowerUpOptions& options);

nlohmann::ordered_json to_json(const PowerUpFindings& findings);
PowerUpFindings power_up_findings_of(const nlohmann::ordered_json& json);

}  // namespace racebeam
