// navigator: flies the camera. Once per frame it adds the velocity and changes the room.
//
// What    position is room centre minus camera. On the last line of a frame (nav_line) it borrows
//         the corner adder of decision_datapath for at most 6 clocks: add the velocity, compare
//         with the room's box on the + side, then on the - side, and move to the neighbour of the
//         lowest axis that left the box. One room change a frame.
// Size    22 register bits: state 3, x 3 (steps of 64), y 3 (odd multiples of 32), z 9, room j 4;
//         room i = 4 and k = 0 are wired.
// Cycles  starts in the clock after active_start_i, done 6 clocks later at most.
// Comb    nav_line_i, corner_*_i (signs) -> nav_axis_o, nav_negative_o, nav_op_o, nav_move_o; off
//         the nav_line: axis 0, hold.
// Stall   none.
// Reset   rst_ni or nav_reset_i: start position (0, start_y, 0), room j = 0, idle.
// Test    tests/navigator_test.cpp
// Source  contract section 13.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/constants.h"
#include "sc/unit.h"

namespace racebeam {

enum navigator_state {
  NavIdle = 0,
  NavToPlus = 1,
  NavCheckPlus = 2,
  NavCheckMinus = 3,
  NavFinish = 4,
  NavStore = 5,
  NavAdjust = 6,
};

/// What decision_datapath does to its corner on the nav_line (S half size, R position of the room).
enum corner_op {
  CornerHold = 0,
  CornerAddVelocity = 1,
  CornerAddS = 2,
  CornerSubtract2S = 3,
  CornerLeavePlus = 4,   // - R - S
  CornerLeaveMinus = 5,  // - R + S
  CornerAddR = 6,
};

/// Behaviour of navigator.
struct navigator_core {
  int nav_state_q = NavIdle;
  vec3 position_q{};  // signed, 9 bits; the wired low bits of x and y included
  int room_j_q = 0;

  struct inputs {
    bool reset;  // reset or nav_reset
    int start_y;
    bool start;  // nav_line and active_start
    vec3 corner;
    int room;  // room id of decision_datapath
  };
  struct outputs {
    int axis;
    bool negative;
    int op;     // corner_op
    bool move;  // the room becomes the neighbour
  };

  static constexpr int wired_room_i = 4;
  int room() const { return room_j_q << 4 | wired_room_i; }
  outputs comb(bool nav_line, const vec3& corner) const;
  void clock(const inputs& in);
};

/// Pins of navigator.
class navigator : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<1> nav_reset_i{"nav_reset_i"};
  // vga_timing
  in_port<1> nav_line_i{"nav_line_i"};
  in_port<1> active_start_i{"active_start_i"};
  // sequencer
  in_port<9> start_y_i{"start_y_i"};  // signed
  // decision_datapath
  axes_in<CornerBits> corner_i{"corner", "_i"};  // signed
  in_port<RoomBits> room_i{"room_i"};
  axes_out<NavigatorBits> nav_position_o{"nav_position", "_o"};  // signed, room centre minus camera
  out_port<RoomBits> nav_room_o{"nav_room_o"};                   // room of the camera
  out_port<2> nav_axis_o{"nav_axis_o"};
  out_port<1> nav_negative_o{"nav_negative_o"};  // look towards negative coordinates
  out_port<3> nav_op_o{"nav_op_o"};              // corner_op
  out_port<1> nav_move_o{"nav_move_o"};          // room := neighbour

  explicit navigator(const sc_core::sc_module_name& name);

  /// Puts the camera to the place of `from` (back door, between clocks).
  void deposit(const navigator_core& from);

 private:
  void seq();
  void comb();
  bool reset() const { return !rst_ni.value() || nav_reset_i.value(); }

  navigator_core core_;
  sc_core::sc_event moved_{"moved"};
  sc_core::sc_event_or_list corner_events_;
  bool asleep_ = true;
};

}  // namespace racebeam
