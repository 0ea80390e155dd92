// Port traffic of a run: what a file of it says of itself, and whether it is of this run.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/run.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

/// `source`: as in TrafficHead.
TrafficHead traffic_head(const Run& run, const std::string& unit, const std::string& source,
                         const std::vector<PortTraffic::Port>& ports);

/// Throws UsageError if the traffic in `path` is of another unit, scene, program or knobs than
/// those of `run`.
void expect_traffic(const std::string& path, const TrafficHead& head, const Run& run,
                    const std::string& unit);

/// The frames that a chip was put through, by frame of the raster, as place_of() takes them.
std::vector<int> frames_of(const std::vector<TrafficMark>& marks, std::uint64_t clocks,
                           const Raster& raster);

}  // namespace racebeam
