// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sequencer.h"

namespace racebeam {

namespace {

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

sequencer_core::outputs sequencer_core::comb(const inputs& in, const knobs& k) const {
  const int e = scene_selector();
  const scene_choice& scene = scene_choices[e];
  outputs o;
  o.scene_flags = scene.flags;
  o.palette = e == 5 && part() == 4 ? 0 : scene.palette;
  o.shading_b = scene.shading_b;
  o.scene_interlace = scene.interlace;
  o.start_y = scene.start_y;
  o.velocity_z = scene.velocity_z;
  o.variant = part() == 1 ? (frame_q >> 7 & 7) ^ 4 : 0;
  if (part() == 4) {
    const int u = frame_q >> 7 & 7;
    o.variant = u >= 4 ? u ^ 2 : u;
  }
  o.fast = lock_enabled() || (part() == 4 && e == 5);
  o.inverse = part() == 4 && pattern() == 0 && (measure() & 1);
  o.nav_reset = frame_q % 2048 == 0 || ((part() == 1 || part() == 4) && frame_q % 256 == 0);
  o.lock = false;
  if (lock_enabled()) {
    const int gate = rescaled(in.dr2_y, k.dr_bits, DrBits);
    if (lock_partial() && (gate >> 6 & 3) == 0) {
      o.palette = pattern() <= 1 ? 0 : (measure() & 2 ? 0 : 1);
    } else {
      o.palette = 2;
      o.lock = in.run;
    }
  }
  return o;
}

int sequencer_core::angle(int src, int y) const {
  const outputs o = comb({}, {});
  const int faster = o.fast ? 2 : 0;
  const auto time = [&](int shift) { return (frame_q << (shift | faster)) % 8192 >> 3; };
  const int y9 = wrap_signed(y, 9);
  const bool twisted = o.variant >= 1 && o.variant <= 3;
  const int y_shift = o.variant == 3;
  switch (src) {
    case AngleYaw: return (time(1) + (twisted ? y9 * (1 << y_shift) : 0)) & 1023;
    case AnglePitch:
      return ((time(0) ^ 1023) + (twisted && o.variant != 1 ? y9 * (1 << y_shift) : 0)) & 1023;
    default:
      if (o.variant < 4) return 96;
      return (time(2) + (o.variant >= 6 ? y9 : 0)) & 255;
  }
}

sequencer::sequencer(const sc_core::sc_module_name& name, const knobs& k)
    : sc_module(name), knobs_(k) {
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
  const auto o = core_.comb({true, false, run_i.value() != 0, dr2_y_i.signed_value()}, knobs_);
  frame_o.drive(core_.frame_q);
  scene_flags_o.drive(o.scene_flags);
  palette_o.drive(o.palette);
  shading_b_o.drive(o.shading_b);
  scene_interlace_o.drive(o.scene_interlace);
  lock_o.drive(o.lock);
  inverse_o.drive(o.inverse);
  start_y_o.drive(o.start_y);
  velocity_z_o.drive(o.velocity_z);
  nav_reset_o.drive(o.nav_reset);
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
