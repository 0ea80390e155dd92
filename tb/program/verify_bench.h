// Test benches in Verilog of what `racebeam verify` plays to a unit alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// What a bench drives.
struct BenchTraffic {
  static constexpr std::uint64_t MostClocks = 20'000;

  std::string stream;        ///< a file; empty: random traffic
  std::uint64_t clocks = 0;  ///< of that, MostClocks at most
  unsigned seed = 0;
  std::string command;  ///< that has made the bench
};

/// Writes FILE.v, for the RTL of `dut`, which is built with its signals, or a netlist of it. Only
/// one such call and nothing else of SystemC may happen in a process. Throws RtlError, RtlFault,
/// UsageError, OutputError.
void write_bench(const UnitUnderTest& dut, const BenchTraffic& traffic, const std::string& file);

}  // namespace racebeam
