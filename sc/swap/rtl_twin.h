// rtl_twin: the RTL of a unit behind the unit's pins, in the place of its model.
//
// The RTL is verilated to C++ and lives in a plug-in. It is evaluated when an input changes that
// reaches an output, and at the rising edge; outputs are written when they change.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/swap/rtl_instance.h"

namespace racebeam {

/// `Unit` is the model whose pins it has.
template <class Unit>
class rtl_twin : public Unit::pins, public probed {
 public:
  /// From a plug-in, built with what is `wanted`. Throws RtlError.
  rtl_twin(const sc_core::sc_module_name& name, const std::vector<rtl_parameter>& wanted,
           const std::string& plugin)
      : Unit::pins(name), rtl_(plugin, Unit::unit_name, ports_of(*this), wanted) {
    SC_HAS_PROCESS(rtl_twin);
    SC_METHOD(comb);
    this->sensitive << rtl_.moved();
    if constexpr (has_clock<typename Unit::pins>::value) {
      SC_METHOD(seq);
      this->sensitive << this->clk_i.pos();
      this->dont_initialize();
    }
  }

  std::vector<probe> probes() const override { return rtl_.probes(); }

  // The back doors of sequencer_pins and navigator_pins.
  void deposit(int frame) {
    rtl_.seek(frame);
    comb();
  }
  void deposit(const vec3& position, int room) {
    rtl_.place(position, room);
    comb();
  }
  /// Lets `put` write to the RTL, as the back door of another unit's model does to that.
  template <class Put>
  void put(const Put& put) {
    put(rtl_);
    comb();
  }

 private:
  template <class Pins, class = void>
  struct has_clock : std::false_type {};
  template <class Pins>
  struct has_clock<Pins, std::void_t<decltype(Pins::clk_i)>> : std::true_type {};

  void comb() { rtl_.follow(); }
  void seq() { rtl_.clock(); }

  rtl_instance rtl_;
};

}  // namespace racebeam
