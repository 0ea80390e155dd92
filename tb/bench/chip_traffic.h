// The traffic of units in the wired chip, recorded.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/bench/wired_bench.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

/// Who takes the traffic, once the ports are known.
using OpenSink = std::function<TrafficSink&(const std::vector<PortTraffic::Port>& ports)>;

/// Puts the chip through `frames`, or pictures, as `verify` does: in reset, then each of them after
/// seek(). `done` is told of each. Throws what WiredBench and the sink throw.
void record_chip_traffic(const WiredBench::Setting& setting, const std::string& unit,
                         const std::vector<int>& frames, const OpenSink& open,
                         const std::function<void(int frames, std::uint64_t clocks)>& done);

/// The same of several units in one run. `open` is told the number of the unit.
void record_chip_traffic(
    const WiredBench::Setting& setting, const std::vector<std::string>& units,
    const std::vector<int>& frames,
    const std::function<TrafficSink&(std::size_t, const std::vector<PortTraffic::Port>&)>& open,
    const std::function<void(int frames, std::uint64_t clocks)>& done);

/// The first `clocks` clocks of a unit or of engine::top in the chip of models, from power-up on:
/// one in reset, then those of frame 0 and what follows. Throws Interrupted.
PortTraffic traffic_from_power_up(const WiredBench::Setting& setting, const std::string& unit,
                                  std::uint64_t clocks);

}  // namespace racebeam
