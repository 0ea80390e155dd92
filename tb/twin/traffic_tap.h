// Listens at the ports of a unit that is simulated: its traffic, as lockstep sees it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sc/swap/rtl_instance.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

/// All ports of a module but its clock, as traffic has them.
std::vector<PortTraffic::Port> traffic_ports(const sc_core::sc_module& module);

class TrafficTap {
 public:
  /// At the pins of `module`; what it hears goes to `sink`.
  TrafficTap(const std::string& unit, const sc_core::sc_module& module, TrafficSink& sink);
  ~TrafficTap();

  /// The clock that ends: to be called at its edge, its wires settled.
  void edge();
  /// What a back door does to RTL beside the unit, which it does through its pins, is heard as
  /// private clocks.
  template <class Put>
  void deposit(const Put& put) {
    put(*rtl_);
    pass_on();
  }

 private:
  struct BackDoor;
  void pass_on();

  TrafficSink& sink_;
  std::vector<any_port*> pins_;
  std::vector<wire_contents> wires_;  // once they are bound
  std::vector<std::uint64_t> row_;
  std::unique_ptr<BackDoor> door_;
  std::unique_ptr<rtl_instance> rtl_;
};

}  // namespace racebeam
