// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/navigator.h"

namespace racebeam {

namespace {

// The chip's room: only j, bits 4 to 7, is stored.
constexpr int WiredRoom = 4, WiredRoomMask = 15 << 4;

int stored_room(int room, const knobs& k) {
  return k.free_flight ? room : (room & WiredRoomMask) | WiredRoom;
}

}  // namespace

navigator_core::outputs navigator_core::comb(bool nav_line, const vec3& corner) const {
  if (!nav_line) return {0, false, CornerHold, false, false};
  const bool odd = nav_state_q & 1;
  int axis = 0;
  bool any = false;
  for (int a = 2; a >= 0; --a)
    if ((corner[a] < 0) != odd) {
      axis = a;
      any = true;
    }
  outputs o{axis, false, CornerHold, false, any};
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
    case NavTryPlus:
    case NavTryDone: o.op = CornerAddS; break;
    case NavTryCheckPlus: o.op = any ? CornerHold : CornerSubtract2S; break;
    case NavTryNext: o.op = CornerCamera; break;
    default: break;
  }
  return o;
}

void navigator_core::clock(const inputs& in, const knobs& k) {
  if (in.reset) {
    *this = {};
    store(in.start, k);
    room_q = stored_room(in.start_room, k);
    return;
  }
  const bool found = comb(true, in.corner).any;
  if (nav_state_q == NavToPlus || nav_state_q == NavStore) store(in.corner, k);
  if (nav_state_q == NavStore) room_q = stored_room(in.room, k);
  if (in.go) {
    nav_state_q = NavAdjust;
    portal_q = 0;
    return;
  }
  if (nav_state_q == NavTryNext) ++portal_q;
  nav_state_q = next_state(found, k);
}

void navigator_core::store(const vec3& corner, const knobs& k) {
  for (int a = 0; a < 3; ++a) position_q[a] = wrap_signed(corner[a], k.navigator_bits);
  if (k.free_flight) return;
  position_q[0] &= ~63;
  position_q[1] = (position_q[1] & ~63) | 32;
}

// `found`: some axis qualifies, by the parity of the state's code.
int navigator_core::next_state(bool found, const knobs& k) const {
  const bool another = portal_q + 1 < k.portals_per_face;
  switch (nav_state_q) {
    case NavAdjust: return NavToPlus;
    case NavToPlus: return NavCheckPlus;
    case NavCheckPlus: return found ? NavFinish : NavCheckMinus;
    case NavCheckMinus: return found ? NavFinish : NavIdle;
    case NavFinish: return another ? NavTryPlus : NavStore;
    case NavTryPlus: return NavTryCheckPlus;
    case NavTryCheckPlus: return found ? NavTryNext : NavTryCheckMinus;
    case NavTryCheckMinus: return found ? NavTryNext : NavTryDone;
    case NavTryDone: return NavStore;
    case NavTryNext: return NavToPlus;
    default: return NavIdle;
  }
}

navigator::navigator(const sc_core::sc_module_name& name, const knobs& k)
    : navigator_pins(name), knobs_(k), core_(navigator_core::at_power_up(k.free_flight)) {
  SC_HAS_PROCESS(navigator);
  SC_METHOD(seq);
  sensitive << rst_ni << nav_reset_i << nav_line_i << active_start_i << start_i.x << start_i.y
            << start_i.z << start_room_i;
  SC_METHOD(comb);
  sensitive << moved_ << nav_line_i;
}

// Sleeps but for reset and the few clocks of the nav_line in which it flies.
void navigator::seq() {
  if (!asleep_) {
    core_.clock(
        {reset(), start_i.signed_value(), start_room_i.value(),
         nav_line_i.value() && active_start_i.value(), corner_i.signed_value(), room_i.value()},
        knobs_);
    moved_.notify(sc_core::SC_ZERO_TIME);
  }
  const bool go = nav_line_i.value() && active_start_i.value();
  const bool held = core_.portal_q == 0 && core_.room_q == start_room_i.value() &&
                    core_.position_q == start_i.signed_value();
  const bool needed = go || core_.nav_state_q != NavIdle || (reset() && !held);
  asleep_ = !needed;
  if (needed) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void navigator::comb() {
  nav_position_o.drive(core_.position_q);
  nav_room_o.drive(core_.room_q);
  nav_portal_o.drive(core_.portal_q);
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

void navigator::deposit(const vec3& position, int room) {
  core_.position_q = position;
  core_.room_q = room;
  moved_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace racebeam
