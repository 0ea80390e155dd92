// Port traffic of one unit, clock by clock: what its inputs had, and what its outputs said.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/twin/unit_bench.h"

namespace racebeam {

struct PortTraffic {
  struct Port {
    std::string name;
    int bits;
    bool input;
    bool optional = false;  ///< RTL may do without it
  };

  std::string unit;
  std::vector<Port> ports;  ///< all but the clock
  /// By clock, then by port: raw bits as settled, before the rising edge that ends the clock. The
  /// outputs of the first clock mean nothing: registers have no value yet.
  std::vector<std::uint64_t> values;

  std::uint64_t clocks() const { return ports.empty() ? 0 : values.size() / ports.size(); }
  const std::uint64_t* row(std::uint64_t clock) const {
    return values.data() + clock * ports.size();
  }
  /// Appends the settled values of the pins of `bench`, whose order is that of `ports`.
  void append(UnitBench& bench);
};

/// Empty traffic with the ports of the unit on `bench`.
PortTraffic traffic_of(const std::string& unit, const UnitBench& bench);

}  // namespace racebeam
