// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/from_reset.h"

#include <algorithm>

#include "tb/bench/chip_traffic.h"
#include "tb/scene/engines.h"
#include "tb/twin/engine_raster.h"
#include "tb/twin/unit_traffic.h"

namespace racebeam {

bool is_whole_chip(const UnitUnderTest& dut) { return dut.unit == engine_of(dut.k).top; }

std::uint64_t clocks_from_reset(const UnitUnderTest& dut, std::uint64_t usual) {
  if (!is_whole_chip(dut)) return usual;
  const auto frame = static_cast<std::uint64_t>(raster_of(engine_of(dut.k), dut.k).frame_clocks());
  return std::max(usual, frame);
}

PortTraffic traffic_from_reset(const UnitUnderTest& dut, std::uint64_t clocks, unsigned seed) {
  if (is_whole_chip(dut))
    return traffic_from_power_up({engine_of(dut.k), dut.k, dut.scene, dut.frames}, dut.unit,
                                 clocks);
  return record_from_reset(dut, clocks, seed);
}

}  // namespace racebeam
