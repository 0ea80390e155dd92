// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/timeline.h"

namespace racebeam {

namespace {

const turn_row& turn_of(const shot_row& shot, int src) {
  return src == AngleYaw ? shot.yaw : src == AnglePitch ? shot.pitch : shot.fov;
}

}  // namespace

timeline_core::outputs timeline_core::comb(const inputs& in, const scene_program& program,
                                           const knobs& k) const {
  const shot_row& now = shot(program);
  outputs o{};
  o.palette = TablePalette;
  o.colours = now.colours;
  o.shading_b = now.shading_b;
  o.scene_interlace = now.interlace;
  o.inverse = now.inverse;
  o.start = now.start;
  o.start_room = now.start_room;
  o.velocity = now.velocity;
  o.nav_reset = now.restart && now.frame == frame_q;
  if (now.pattern == PatternFull || (now.pattern == PatternPartial && shows_pattern(in.dr2_y, k))) {
    o.colours = now.pattern_colours;
    o.lock = in.run;
  }
  return o;
}

int timeline_core::angle(int src, int y, const scene_program& program) const {
  if (src > AngleFov) src = AngleFov;
  const int value = turns_q[src].value + turn_of(shot(program), src).per_line * wrap_signed(y, 9);
  return value & low_bits(src == AngleFov ? 8 : AngleBits);
}

void timeline_core::clock(const inputs& in, const scene_program& program) {
  if (!in.rst_n || frame_q == program.frames) seek(0, program);
  else if (in.frame_end) next_frame(program);
}

void timeline_core::next_frame(const scene_program& program) {
  ++frame_q;
  const bool cut = shot_q + 1 < static_cast<int>(program.shots.size()) &&
                   program.shots[shot_q + 1].frame == frame_q;
  shot_q += cut;
  for (int src : {AngleYaw, AnglePitch, AngleFov}) {
    const turn_row& row = turn_of(shot(program), src);
    turn& t = turns_q[src];
    if (cut && row.load) {
      t = {row.start, 0};
    } else if (++t.waited == row.every) {
      t = {(t.value + row.step) & low_bits(AngleBits), 0};
    }
  }
}

void timeline_core::seek(int frame, const scene_program& program) {
  frame_q = frame;
  shot_q = 0;
  for (int src : {AngleYaw, AnglePitch, AngleFov}) {
    const shot_row* since = &program.shots[0];
    for (std::size_t i = 0; i < program.shots.size() && program.shots[i].frame <= frame; ++i) {
      shot_q = static_cast<int>(i);
      if (turn_of(program.shots[i], src).load) since = &program.shots[i];
    }
    const turn_row& row = turn_of(*since, src);
    const int frames = frame - since->frame;
    turns_q[src] = {(row.start + row.step * (frames / row.every)) & low_bits(AngleBits),
                    frames % row.every};
  }
}

timeline::timeline(const sc_core::sc_module_name& name, const knobs& k,
                   const scene_program& program)
    : sequencer_pins(name), knobs_(k), program_(program) {
  core_.seek(0, program_);
  SC_HAS_PROCESS(timeline);
  SC_METHOD(seq);
  sensitive << frame_end_i << rst_ni;
  SC_METHOD(comb);
  sensitive << frame_changed_ << run_i;
  SC_METHOD(comb_angle);
  sensitive << frame_changed_ << src_i << y_i;
}

// Sleeps until the counter can change: reset, the end of a frame, or the one-clock frame.
void timeline::seq() {
  if (counting_) {
    const int before = core_.frame_q;
    core_.clock({rst_ni.value() != 0, frame_end_i.value() != 0, false, 0}, program_);
    if (core_.frame_q != before) frame_changed_.notify(sc_core::SC_ZERO_TIME);
  }
  counting_ = !rst_ni.value() || frame_end_i.value() || core_.frame_q == program_.frames;
  if (counting_) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void timeline::comb() {
  drive(core_.frame_q,
        core_.comb({true, false, run_i.value() != 0, dr2_y_i.signed_value()}, program_, knobs_));
  // dr2 moves in most clocks: it is listened to only where it matters.
  if (core_.shot(program_).pattern == PatternPartial) {
    if (lock_events_.size() == 0)
      lock_events_ |= frame_changed_, lock_events_ |= run_i->value_changed_event(),
          lock_events_ |= dr2_y_i->value_changed_event();
    next_trigger(lock_events_);
  }
}

void timeline::comb_angle() {
  angle_o.drive(core_.angle(src_i.value(), y_i.signed_value(), program_));
}

void timeline::deposit(int frame) {
  core_.seek(frame, program_);
  frame_changed_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace racebeam
