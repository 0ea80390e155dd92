// WiringCheck: the ports of every unit inside racebeam_top against those of the SystemC chip, in
// every clock: whether a wrong pin comes from a unit or from a wire between units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/swap/rtl_instance.h"

namespace racebeam {

class WiringCheck {
 public:
  /// `top` simulates racebeam_top with visible signals; the children of `chip` are the units. Both
  /// outlive the check. A flattened netlist has no port of a unit, and nothing is looked at. Throws
  /// RtlError if `top` has some, but lacks one.
  WiringCheck(rtl_instance& top, const sc_core::sc_module& chip);

  /// Looks at the settled wires of a clock until something is found: a wire whose ends differ, or,
  /// from the second line on, an output that is not the model's.
  void look(std::uint64_t clock);

  /// The earliest difference and what it means.
  std::string text() const;

 private:
  struct Port {
    std::string unit, name;
    bool is_input;
    any_port* pin;
    rtl_instance::value rtl;
    wire_contents wire{};
    int driver = NoDriver;  // of an input: the output on the same wire
    std::string full_name() const { return unit + "." + name; }
  };
  static constexpr int NoDriver = -1;

  void join();
  static bool differs(const Port& port) { return port.rtl.read() != port.wire.value(); }
  std::string wrong_wire() const;
  std::string wrong_outputs() const;

  std::vector<Port> ports_;
  bool joined_ = false;
  std::string found_;
};

}  // namespace racebeam
