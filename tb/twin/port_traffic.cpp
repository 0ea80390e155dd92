// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/port_traffic.h"

namespace racebeam {

void PortTraffic::append(UnitBench& bench) {
  for (const UnitBench::Pin* pin : bench.pins()) values.push_back(pin->value());
}

PortTraffic traffic_of(const std::string& unit, const UnitBench& bench) {
  PortTraffic traffic;
  traffic.unit = unit;
  for (const UnitBench::Pin* pin : bench.pins())
    traffic.ports.push_back({pin->name, pin->bits, pin->input, pin->optional});
  return traffic;
}

}  // namespace racebeam
