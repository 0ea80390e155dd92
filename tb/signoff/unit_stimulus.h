// What `racebeam verify` drives a unit with when it is alone, recorded from the model: random
// traffic, and the walks of its engine's row.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/twin/port_stream.h"
#include "tb/twin/port_traffic.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// The name of the stream of random traffic.
constexpr const char* RandomStream = "random";

/// A stream of traffic from power-up on, in files that grow from part to part: most mutants need
/// only the first.
struct RecordedStream {
  std::string name;  ///< RandomStream, "walk", or the name of a counterexample
  std::vector<std::string> parts;
  std::uint64_t clocks = 0;
};

/// Records all streams of a unit into files in `folder`: `random` clocks of random traffic, and its
/// walk if it has one. The first clock of each is in reset. To be called in a process that has
/// nothing of SystemC. Throws OutputError, Interrupted.
std::vector<RecordedStream> record_stimulus(const UnitUnderTest& dut, std::uint64_t random,
                                            unsigned seed, const std::string& folder);

/// All clocks of a stream.
PortTraffic whole_traffic(const RecordedStream& stream);
/// The inputs of all clocks up to one, it included: a row for each clock.
std::vector<std::vector<std::uint64_t>> input_rows(const PortTraffic& traffic, std::uint64_t clock);

/// What the model says to the inputs of a stream. To be called as record_stimulus().
PortTraffic model_answers(const UnitUnderTest& dut, const PortStream& stream);

/// Traffic without a clock, with the ports of the unit. To be called as record_stimulus().
PortTraffic ports_of(const UnitUnderTest& dut);

void write_traffic(const PortTraffic& traffic, const std::string& path);
/// The traffic of a file that write_traffic() has written; throws std::runtime_error of others.
PortTraffic read_traffic(const std::string& path);

}  // namespace racebeam
