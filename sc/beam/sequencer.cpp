// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/sequencer.h"

namespace racebeam {

namespace {

constexpr int StartRoom = 4;  // i = 4, j = 0, k = 0

/// One row of contract 17.1.
struct scene_choice {
  int flags, palette;
  bool shading_b;
  int start_y, velocity_z;
  bool interlace;
};

constexpr scene_choice pillars{SceneWindows | SceneBlocked, 0, false, -224, -1, true};
constexpr scene_choice scene_choices[8] = {
    pillars,
    pillars,
    {SceneTunnel, 1, true, 160, -2, false},
    {SceneHeights, 0, false, -224, -1, true},
    {SceneHeights | SceneBlocked, 1, false, -224, -1, true},
    {SceneWindows | ScenePortals | SceneBlocked | SceneNarrow, 2, true, 32, -1, true},
    {SceneTunnel | SceneNarrow, 0, false, 160, -2, false},
    {SceneHeights | SceneNarrow, 1, false, -224, -1, true},
};

}  // namespace

int sequencer_core::variant() const {
  const int u = frame_q >> 7 & 7;
  if (part() == 1) return u ^ 4;
  if (part() == 4) return u >= 4 ? u ^ 2 : u;
  return 0;
}

sequencer_core::outputs sequencer_core::comb(const inputs& in, const knobs& k) const {
  const int e = scene_selector();
  const scene_choice& scene = scene_choices[e];
  outputs o{};
  o.scene_flags = scene.flags;
  o.palette = e == 5 && part() == 4 ? 0 : scene.palette;
  o.shading_b = scene.shading_b;
  o.scene_interlace = scene.interlace;
  o.start = {0, scene.start_y, 0};
  o.start_room = StartRoom;
  o.velocity = {0, 0, scene.velocity_z};
  o.inverse = part() == 4 && pattern() == 0 && (measure() & 1);
  o.nav_reset = frame_q % 2048 == 0 || ((part() == 1 || part() == 4) && frame_q % 256 == 0);
  if (lock_enabled()) {
    if (lock_partial() && !shows_pattern(in.dr2_y, k)) {
      o.palette = pattern() <= 1 ? 0 : (measure() & 2 ? 0 : 1);
    } else {
      o.palette = 2;
      o.lock = in.run;
    }
  }
  return o;
}

int sequencer_core::angle(int src, int y) const {
  const int faster = fast() ? 2 : 0, v = variant();
  const auto time = [&](int shift) { return (frame_q << (shift | faster)) % 8192 >> 3; };
  const int y9 = wrap_signed(y, 9);
  const int twist = v == 3 ? 2 * y9 : v == 1 || v == 2 ? y9 : 0;
  switch (src) {
    case AngleYaw: return 2 * ((time(1) + twist) & 1023);
    case AnglePitch: return 2 * (((time(0) ^ 1023) + (v == 1 ? 0 : twist)) & 1023);
    default: return v < 4 ? 96 : (time(2) + (v >= 6 ? y9 : 0)) & 255;
  }
}

void sequencer_pins::drive(int frame, const sequencer_outputs& o) {
  frame_o.drive(frame);
  scene_flags_o.drive(o.scene_flags);
  palette_o.drive(o.palette);
  colours_o.drive(o.colours);
  shading_b_o.drive(o.shading_b);
  scene_interlace_o.drive(o.scene_interlace);
  lock_o.drive(o.lock);
  inverse_o.drive(o.inverse);
  start_o.drive(o.start);
  start_room_o.drive(o.start_room);
  velocity_o.drive(o.velocity);
  nav_reset_o.drive(o.nav_reset);
}

sequencer::sequencer(const sc_core::sc_module_name& name, const knobs& k)
    : sequencer_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sequencer);
  SC_METHOD(seq);
  sensitive << frame_end_i << rst_ni;
  SC_METHOD(comb);
  sensitive << frame_changed_ << run_i;
  SC_METHOD(comb_angle);
  sensitive << frame_changed_ << src_i << y_i;
}

// Sleeps until the counter can change: reset, the end of a frame, or the one-clock frame 12799.
void sequencer::seq() {
  if (counting_) {
    const int before = core_.frame_q;
    core_.clock({rst_ni.value() != 0, frame_end_i.value() != 0, false, 0});
    if (core_.frame_q != before) frame_changed_.notify(sc_core::SC_ZERO_TIME);
  }
  counting_ = !rst_ni.value() || frame_end_i.value() || core_.frame_q == DemoFrames;
  if (counting_) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void sequencer::comb() {
  drive(core_.frame_q,
        core_.comb({true, false, run_i.value() != 0, dr2_y_i.signed_value()}, knobs_));
  // dr2 moves in most clocks: it is listened to only where it matters.
  if (core_.lock_enabled() && core_.lock_partial()) {
    if (lock_events_.size() == 0)
      lock_events_ |= frame_changed_, lock_events_ |= run_i->value_changed_event(),
          lock_events_ |= dr2_y_i->value_changed_event();
    next_trigger(lock_events_);
  }
}

void sequencer::comb_angle() { angle_o.drive(core_.angle(src_i.value(), y_i.signed_value())); }

void sequencer::deposit(int frame) {
  core_.frame_q = frame;
  frame_changed_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace racebeam
