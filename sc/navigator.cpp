// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/navigator.h"

namespace racebeam {

navigator_core::outputs navigator_core::comb(bool nav_line, const vec3& corner) const {
  if (!nav_line) return {0, false, CornerHold, false};
  const bool odd = nav_state_q & 1;
  int axis = 0;
  bool any = false;
  for (int a = 2; a >= 0; --a)
    if ((corner[a] < 0) != odd) {
      axis = a;
      any = true;
    }
  outputs o{axis, false, CornerHold, false};
  switch (nav_state_q) {
    case NavAdjust: o.op = CornerAddVelocity; break;
    case NavToPlus: o.op = CornerAddS; break;
    case NavCheckPlus:
      o.move = any;
      o.op = any ? CornerLeavePlus : CornerSubtract2S;
      break;
    case NavCheckMinus:
      o.move = o.negative = any;
      o.op = any ? CornerLeaveMinus : CornerHold;
      break;
    case NavFinish: o.op = CornerAddR; break;
    default: break;
  }
  return o;
}

void navigator_core::clock(const inputs& in) {
  if (in.reset) {
    *this = {};
    position_q[1] = in.start_y;
    return;
  }
  if (nav_state_q == NavToPlus || nav_state_q == NavStore) {
    position_q[0] = wrap_signed(in.corner[0], NavigatorBits) & ~63;
    position_q[1] = (wrap_signed(in.corner[1], NavigatorBits) & ~63) | 32;
    position_q[2] = wrap_signed(in.corner[2], NavigatorBits);
  }
  if (nav_state_q == NavStore) room_j_q = in.room >> 4 & 15;
  if (in.start) {
    nav_state_q = NavAdjust;
    return;
  }
  const bool move = comb(true, in.corner).move;
  switch (nav_state_q) {
    case NavAdjust: nav_state_q = NavToPlus; break;
    case NavToPlus: nav_state_q = NavCheckPlus; break;
    case NavCheckPlus: nav_state_q = move ? NavFinish : NavCheckMinus; break;
    case NavCheckMinus: nav_state_q = move ? NavFinish : NavIdle; break;
    case NavFinish: nav_state_q = NavStore; break;
    default: nav_state_q = NavIdle;
  }
}

navigator::navigator(const sc_core::sc_module_name& name) : sc_module(name) {
  SC_HAS_PROCESS(navigator);
  SC_METHOD(seq);
  sensitive << rst_ni << nav_reset_i << nav_line_i << active_start_i << start_y_i;
  SC_METHOD(comb);
  sensitive << moved_ << nav_line_i;
}

// Sleeps but for reset and the few clocks of the nav_line in which it flies.
void navigator::seq() {
  if (!asleep_) {
    core_.clock({reset(), start_y_i.signed_value(), nav_line_i.value() && active_start_i.value(),
                 corner_i.signed_value(), room_i.value()});
    moved_.notify(sc_core::SC_ZERO_TIME);
  }
  const bool start = nav_line_i.value() && active_start_i.value();
  const bool held = core_.room_j_q == 0 && core_.position_q == vec3{0, start_y_i.signed_value(), 0};
  const bool needed = start || core_.nav_state_q != NavIdle || (reset() && !held);
  asleep_ = !needed;
  if (needed) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void navigator::comb() {
  nav_position_o.drive(core_.position_q);
  nav_room_o.drive(core_.room());
  const auto o = core_.comb(nav_line_i.value(), corner_i.signed_value());
  nav_axis_o.drive(o.axis);
  nav_negative_o.drive(o.negative);
  nav_op_o.drive(o.op);
  nav_move_o.drive(o.move);
  // The corner moves all the time: it is listened to on the navigator's own line only.
  if (nav_line_i.value()) {
    if (corner_events_.size() == 0)
      corner_events_ = moved_ | nav_line_i->value_changed_event() |
                       corner_i.x->value_changed_event() | corner_i.y->value_changed_event() |
                       corner_i.z->value_changed_event();
    next_trigger(corner_events_);
  }
}

void navigator::deposit(const navigator_core& from) {
  core_.position_q = from.position_q;
  core_.room_j_q = from.room_j_q;
  moved_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace racebeam
