// RTL of a unit without SystemC around it: recorded port traffic goes into it as fast as it runs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

/// An output that is not as recorded.
struct TrafficDifference {
  std::uint64_t clock = 0;  ///< of the traffic
  std::size_t port = 0;     ///< number of PortTraffic::ports
  std::uint64_t expected = 0, got = 0;
};

/// One instance of a plug-in, from power-up on.
class BareRtl {
 public:
  /// Joins its ports to those of `traffic` by name; inputs that the traffic does not have stay 0
  /// until hold() says otherwise. Throws RtlError: no plug-in, ports of the traffic that are
  /// missing or wrongly sized.
  BareRtl(const std::string& plugin, const PortTraffic& traffic);

  /// The value of an input that the traffic does not have, such as the number of a mutant. Throws
  /// RtlError if there is no such input.
  void hold(const std::string& input, std::uint64_t value);
  /// Goes on through the clocks `from` (included) to `to` (excluded) of traffic with the same
  /// ports, up to the first output that is not as recorded; the outputs of its first
  /// clock are not compared. Throws RtlFault.
  std::optional<TrafficDifference> run(const PortTraffic& traffic, std::uint64_t from,
                                       std::uint64_t to);

 private:
  struct Joint {
    std::size_t port;  // of the traffic
    const rtl_port* rtl;
  };

  rtl_library library_;
  std::vector<Joint> inputs_, outputs_;
  bool begun_ = false;  // it has had a clock
};

}  // namespace racebeam
