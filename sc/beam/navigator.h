// navigator: flies the camera. Once per frame it adds the velocity and changes the room.
//
// What    position is room centre minus camera. On the last line of a frame (nav_line) it borrows
//         the corner adder of decision_datapath for at most 6 clocks: add the velocity, compare
//         with the room's box on the + side, then on the - side, and move to the neighbour of the
//         lowest axis that left the box. One room change a frame. Where faces may have several
//         portals, it then tests the new room's box, and tries the next portal while the camera
//         is outside: at most 9 clocks more for each.
// Size    22 register bits: state 3, x 3 (steps of 64), y 3 (odd multiples of 32), z 9, room j 4;
//         room i = 4 and k = 0 are wired. Knob free_flight: state 4, three coordinates of
//         navigator_bits, the whole room, portal 2.
// Cycles  starts in the clock after active_start_i.
// Comb    nav_line_i, corner_*_i (signs) -> nav_axis_o, nav_negative_o, nav_op_o, nav_move_o; off
//         the nav_line: axis 0, hold. nav_portal_o: a register.
// Stall   none.
// Reset   rst_ni or nav_reset_i: start_*_i, start_room_i, idle. At power-up 0, but for wired bits.
// Knobs   from the scene: navigator_bits, free_flight, portals_per_face.
// Twin    rtl/beam/navigator.sv
// Test    tests/beam/navigator_test.cpp
// Source  contract section 13.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/codes.h"
#include "sc/beam/knobs.h"

namespace racebeam {

enum navigator_state {
  NavIdle = 0,
  NavToPlus = 1,
  NavCheckPlus = 2,
  NavCheckMinus = 3,
  NavFinish = 4,
  NavStore = 5,
  NavAdjust = 6,
  // Several portals in a face: is the camera in the new room?
  NavTryPlus = 8,
  NavTryCheckPlus = 10,
  NavTryCheckMinus = 11,
  NavTryDone = 9,
  NavTryNext = 12,
};

/// Behaviour of navigator.
struct navigator_core {
  int nav_state_q = NavIdle;
  vec3 position_q{0, 32, 0};  // signed; the wired low bits of x and y included
  int room_q = 4;             // the wired bits included
  int portal_q = 0;           // portal that is tried

  /// All flip-flops are 0. In free flight nothing is wired.
  static navigator_core at_power_up(bool free_flight) {
    navigator_core core;
    if (free_flight) {
      core.position_q = {};
      core.room_q = 0;
    }
    return core;
  }

  struct inputs {
    bool reset;  // reset or nav_reset
    vec3 start;
    int start_room;
    bool go;  // nav_line and active_start
    vec3 corner;
    int room;  // room id of decision_datapath
  };
  struct outputs {
    int axis;
    bool negative;
    int op;     // corner_op
    bool move;  // the room becomes the neighbour
    bool any;   // some axis qualifies: corner < 0 in even states, >= 0 in odd ones
  };

  outputs comb(bool nav_line, const vec3& corner) const;
  void clock(const inputs& in, const knobs& k);
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    visit("nav_state_q", 4, [this] { return nav_state_q; });
    visit("portal_q", PortalBits, [this] { return portal_q; });
    const std::string flight = k.free_flight ? "g_free." : "g_along_z.";
    const int wired = k.free_flight ? 0 : 6;  // bits of x and y that are not stored
    const int kept = k.navigator_bits - wired;
    visit(flight + "position_x_q", kept, [this, wired] { return position_q[0] >> wired; });
    visit(flight + "position_y_q", kept, [this, wired] { return position_q[1] >> wired; });
    visit(flight + "position_z_q", k.navigator_bits, [this] { return position_q[2]; });
    if (k.free_flight) visit(flight + "room_q", RoomPortBits, [this] { return room_q; });
    else visit(flight + "room_j_q", 4, [this] { return room_q >> 4; });
  }

 private:
  void store(const vec3& corner, const knobs& k);
  int next_state(bool found, const knobs& k) const;
};

/// Pins of navigator.
class navigator_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<1> nav_reset_i{"nav_reset_i"};
  // vga_timing
  in_port<1> nav_line_i{"nav_line_i"};
  in_port<1> active_start_i{"active_start_i"};
  // sequencer
  axes_in<NavigatorPortBits> start_i{"start", "_i"};  // signed, room centre minus camera
  in_port<RoomPortBits> start_room_i{"start_room_i"};
  // decision_datapath
  axes_in<CornerPortBits> corner_i{"corner", "_i"};  // signed
  in_port<RoomPortBits> room_i{"room_i"};
  axes_out<NavigatorPortBits> nav_position_o{"nav_position", "_o"};  // signed, as start
  out_port<RoomPortBits> nav_room_o{"nav_room_o"};                   // room of the camera
  out_port<2> nav_axis_o{"nav_axis_o"};
  out_port<PortalBits> nav_portal_o{"nav_portal_o"};
  out_port<1> nav_negative_o{"nav_negative_o"};  // look towards negative coordinates
  out_port<3> nav_op_o{"nav_op_o"};              // corner_op
  out_port<1> nav_move_o{"nav_move_o"};          // room := neighbour

  explicit navigator_pins(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// Puts the camera to a place (back door, between clocks).
  virtual void deposit(const vec3& position, int room) = 0;
};

/// The model of navigator: its core behind the pins.
class navigator : public navigator_pins, public probed {
 public:
  using pins = navigator_pins;
  static constexpr const char* unit_name = "navigator";

  navigator(const sc_core::sc_module_name& name, const knobs& k);

  void deposit(const vec3& position, int room) override;
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();
  bool reset() const { return !rst_ni.value() || nav_reset_i.value(); }

  const knobs knobs_;
  navigator_core core_;
  sc_core::sc_event moved_{"moved"};
  sc_core::sc_event_or_list corner_events_;
  bool asleep_ = true;
};

}  // namespace racebeam
