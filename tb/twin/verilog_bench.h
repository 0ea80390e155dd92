// Port traffic of a unit as a self-checking test bench in plain Verilog-2001, for simulators that
// know nothing of this project: of its RTL, or of a netlist of it.
//
// Outputs are compared in each clock after the first one, in reset, strictly: a bit that is unknown
// is wrong. The bench prints PASS and ends by $finish, or FAIL with port, clock, and both values,
// and ends by $stop, so that `vvp -N` and a program of Verilator's have an exit code.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tb/twin/port_traffic.h"

namespace racebeam {

struct VerilogBench {
  /// A register of the unit.
  struct Deposit {
    std::string name;
    std::uint64_t value;
    int bits;
  };

  const PortTraffic& traffic;          ///< what the model says; without ports that the RTL lacks
  bool clocked = true;                 ///< the unit has a clk_i
  std::map<std::uint64_t, int> seeks;  ///< by clock: the frame that a counter of frames goes to
  /// Of the values of `traffic`, those that follow from power-up: not compared. Empty: all are.
  std::vector<bool> unknown;
  /// What the contract leaves without reset, and has after the clock in reset: written there if
  /// DEPOSIT is defined, as four states know nothing of it.
  std::vector<Deposit> deposits;
  std::vector<std::string> parameters;  ///< "Name=value", which a netlist has no more
  std::vector<std::string> comment;     ///< lines of its head, each without its //
};

/// The text; its module is called UNIT_bench.
std::string verilog_bench_text(const VerilogBench& bench);

}  // namespace racebeam
