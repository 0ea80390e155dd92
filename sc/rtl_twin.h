// rtl_twin: the RTL of a unit behind the unit's pins, in the place of its model.
//
// The RTL is verilated to C++ and lives in a plug-in. It is evaluated when an input changes and at
// the rising edge; outputs are written when they change.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/rtl_plugin.h"

namespace racebeam {

/// `Unit` is the model whose pins it has.
template <class Unit>
class rtl_twin : public Unit::pins {
 public:
  /// From the plug-in at `path`; the unit's own RTL if that is empty. Throws RtlError.
  explicit rtl_twin(const sc_core::sc_module_name& name, const knobs& k = {},
                    const std::string& path = "")
      : Unit::pins(name),
        rtl_(path.empty() ? rtl_plugin_path(Unit::unit_name, k) : path, Unit::unit_name,
             ports_of(*this), k) {
    SC_HAS_PROCESS(rtl_twin);
    SC_METHOD(comb);
    for (any_port* port : ports_of(*this))
      if (port->port_name() != std::string("clk_i")) port->sense(this->sensitive);
    if constexpr (has_clock<typename Unit::pins>::value) {
      SC_METHOD(seq);
      this->sensitive << this->clk_i.pos();
      this->dont_initialize();
    }
  }

  // The back doors of sequencer_pins and navigator_pins: the RTL gets there through its pins, in
  // clocks of its own.

  void deposit(int frame) {
    private_edges({{"rst_ni", 0}}, 1);
    private_edges({{"rst_ni", 1}, {"frame_end_i", 1}}, frame);
    comb();
  }
  void deposit(const vec3& position, int room) {
    private_edges({{"rst_ni", 1},
                   {"nav_reset_i", 1},
                   {"start_x_i", position[0]},
                   {"start_y_i", position[1]},
                   {"start_z_i", position[2]},
                   {"start_room_i", room}},
                  1);
    comb();
  }

 private:
  void private_edges(const std::vector<std::pair<const char*, int>>& inputs, int edges) {
    for (const auto& [name, value] : inputs) rtl_.port(name).write(value);
    for (; edges > 0; --edges) rtl_.edge();
  }

  template <class Pins, class = void>
  struct has_clock : std::false_type {};
  template <class Pins>
  struct has_clock<Pins, std::void_t<decltype(Pins::clk_i)>> : std::true_type {};

  void comb() {
    rtl_.settle();
    rtl_.drive();
  }
  void seq() {
    rtl_.edge();
    rtl_.drive();
  }

  rtl_instance rtl_;
};

}  // namespace racebeam
