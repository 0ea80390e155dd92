// The traffic of a unit alone, recorded: random, or on its walk.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "tb/twin/port_traffic.h"
#include "tb/twin/traffic_file.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// What drives a unit alone: RandomTraffic, or the UnitWalk of its engine's row.
enum class LoneTraffic { Random, Walk };

/// The same that `verify` compares, `clocks` of it; the plug-in of `dut` is not looked at. `open`
/// is told the ports, `done` the clocks so far. Nothing else of SystemC may happen in the process.
/// Throws what the sink throws, and Interrupted.
void record_lone_traffic(
    const UnitUnderTest& dut, LoneTraffic kind, std::uint64_t clocks, unsigned seed,
    const std::function<TrafficSink&(const std::vector<PortTraffic::Port>&)>& open,
    const std::function<void(std::uint64_t)>& done);

/// What the model says to random traffic that only its ports bring: no frames are set. The first
/// clock is in reset. Less after an interrupt. Nothing else of SystemC may happen in the process.
PortTraffic record_from_reset(const UnitUnderTest& dut, std::uint64_t clocks, unsigned seed);

}  // namespace racebeam
