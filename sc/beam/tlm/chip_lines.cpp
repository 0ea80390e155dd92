// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/chip_lines.h"

#include "sc/beam/tlm/line_tracer.h"

namespace racebeam {

chip_lines::chip_lines(const options& o)
    : options_(o),
      knobs_(o.k),
      raster_(o.k),
      standard_(chip_knobs::of(o.k) == o.k),
      scene_standard_(scene_knobs::of(o.k) == o.k),
      only_limits_(limit_knobs::of(o.k) == o.k),
      chip_(o.program) {
  reset();
}

void chip_lines::reset() { chip_.clock(false, knobs_); }

void chip_lines::deposit(int frame) { chip_.deposit(frame, knobs_); }

int chip_lines::next_frame() const {
  const int frames = chip_.program ? chip_.program->frames : DemoFrames;
  return chip_.frame() == frames ? 0 : chip_.frame();  // the frame that lasts one clock
}

void chip_lines::run_line() {
  y_ = next_line();
  frame_ = next_frame();
  visible_ = chip_.vga_timing.v_region_q == 1;
  pins_.clear();
  rooms_told_ = {};
  if (options_.sound)
    run_sound_line(chip_.pwm_sound, raster_, knobs_.speed, y_, frame_, sound_changes_);
  const line_setting line = setting();
  const bool pattern = line.choice[0].lock || line.choice[1].lock;
  const bool pattern_before_run = knobs_.head_start > 0;  // in columns before the tracer starts
  if (y_ == LastLine || chip_.navigator.nav_state_q != NavIdle ||
      (pattern && (options_.pins || pattern_before_run)))
    run_slowly();
  else run_fast(line);
}

void chip_lines::run_slowly() {
  column_ = decisions_ = 0;
  started_ = false;
  for (int clock = 0; clock < raster_.size(); ++clock) step(clock);
  if (options_.observer) options_.observer->line_end(y_, decisions_);
}

// One clock of all units but the sound.
void chip_lines::step(int clock) {
  chip_view view;
  int uo;
  if (options_.observer) {
    const chip_core before = chip_;
    uo = chip_.clock_video(true, knobs_, &view);
    observe(before, view, clock);
  } else {
    uo = chip_.clock_video(true, knobs_, &view);
  }
  collector_.observe(view);
  if (options_.pins) pins_.push_back(static_cast<std::uint8_t>(uo));
  if (!visible_ || clock != raster_.column_clock[column_]) return;
  pixels_[column_] = static_cast<std::uint8_t>(pixel_output_core::colour_of_pins(uo));
  if (options_.observer) options_.observer->shown(y_, column_, 1, pixels_[column_]);
  ++column_;
}

void chip_lines::observe(const chip_core& before, const chip_view& v, int clock) {
  if (!v.run || v.line_done || v.line_end) return;
  chip_observer& observer = *options_.observer;
  if (!started_) observer.started(y_, clock);
  started_ = true;
  if (y_ != LastLine) rooms_told_.tell(observer, y_, clock, before.decision_datapath);
  const bool in_return = v.state == StateReturn;
  if (v.emit && !in_return) {
    given_up_ = !v.wall;
    behind_ = before.decision_datapath.is_behind();
  }
  if (v.emit && v.ack)
    observer.interval({y_, clock, before.subdivider.i1_q, v.i2,
                       chip_.interval_fifo.head_value_q & IndexMask,
                       before.decision_datapath.room_q, before.decision_datapath.depth_q,
                       before.decision_datapath.hit_face_q, behind_, given_up_, decisions_});
  if (v.restart && v.i2 != LastPixel) observer.restart(y_, clock, v.i2 + 1);
  const bool adjusting = v.state == StateLeft && v.idx2 != v.i2;
  if (!in_return && !v.emit && !v.second && !adjusting) ++decisions_;
}

}  // namespace racebeam
