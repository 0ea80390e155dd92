// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/chip_lines.h"
#include "sc/beam/tlm/line_tracer.h"
#include "sc/beam/tlm/room_table.h"

namespace racebeam {

namespace {

// Clocks of a frame in which the frame counter and the navigator may still change.
constexpr int SettlingClocks = 4;

template <class Knobs, bool Watch>
line_counts trace_with(chip_core& chip, line_beam& beam, const line_setting& line, int clock) {
  const bool pattern = line.choice[0].lock || line.choice[1].lock;
  return pattern ? trace_line<Knobs, true, Watch>(chip, beam, line, clock)
                 : trace_line<Knobs, false, Watch>(chip, beam, line, clock);
}

}  // namespace

// What holds for the next line while its tracer runs.
line_setting chip_lines::setting() {
  const auto choice = [&](bool shows) {
    const int dr2_y = shows ? rescaled(1 << 6, DrBits, knobs_.dr_bits) : 0;
    const sequencer_inputs in{true, false, true, dr2_y};
    if (!chip_.program) {
      sequencer_core sequencer;
      sequencer.frame_q = frame_;
      return sequencer.comb(in, knobs_);
    }
    timeline_core timeline = chip_.timeline;
    if (timeline.frame_q != frame_) timeline.seek(frame_, *chip_.program);
    return timeline.comb(in, *chip_.program, knobs_);
  };
  const auto plain = choice(false), shown = choice(true);
  const bool pattern = plain.lock || shown.lock;
  const auto colour = [&](int index) {
    return static_cast<std::uint8_t>(pixel_output_core::colour(
        {index, false, plain.inverse, true, true, true, {}, plain.palette, plain.colours, false},
        knobs_));
  };
  const std::uint8_t of_index[] = {colour(0), colour(1), colour(2), colour(3)};
  shown_colours colours;
  for (const bool odd : {false, true})
    for (int display = 0; display < 2 * HalfTone; ++display)
      colours[odd][display] = of_index[pixel_output_core::shown(display, odd)];
  return {knobs_,
          raster_,
          chip_.program ? chip_.program->rooms : rooms(plain.scene_flags),
          chip_.program ? low_bits(RoomPortBits) : low_bits(RoomBits),
          y_,
          knobs_.interlace && plain.scene_interlace && (y_ & 1),
          {plain, shown},
          colours,
          pattern && visible_ ? pixels_.data() : nullptr,
          options_.observer,
          visible_ ? collector_.stats() : unseen_,
          unseen_,
          &rooms_told_,
          options_.apart};
}

const std::vector<room_row>& chip_lines::rooms(int flags) {
  auto& rooms = rooms_[flags];
  if (rooms.empty()) rooms = room_table(flags);
  return rooms;
}

int chip_lines::angle(int src) const {
  return chip_.program ? chip_.timeline.angle(src, y_, *chip_.program)
                       : chip_.sequencer.angle(src, y_);
}

void chip_lines::run_fast(const line_setting& line) {
  const vga_timing_core begin = chip_.vga_timing;
  const bool pattern = line.choice[0].lock || line.choice[1].lock;
  if (options_.pins) indices_.resize(raster_.size());
  beam_.begin({y_, visible_ && !pattern ? pixels_.data() : nullptr, &line.colours,
               visible_ ? &collector_.stats() : nullptr, options_.observer,
               options_.pins ? indices_.data() : nullptr});
  int clock = 0;
  if (y_ == FirstLine)
    for (; clock < SettlingClocks; ++clock) chip_.clock_video(true, knobs_);
  clock = run_camera(clock);
  beam_.hold(clock);
  const line_counts counts = trace(line, clock);
  count(counts);
  beam_.advance(raster_.size() - 1);
  if (options_.pins) show_pins(begin, line);
  chip_.vga_timing = raster_.at(raster_.size() - 1, begin);
  last_clock();
  if (options_.observer) options_.observer->line_end(y_, counts.decisions());
}

// Clocks of the blanking up to the first with the camera in RUN: the tracer and the FIFO are held
// in reset. Its place stays at the root, and of its decisions the last one is kept.
int chip_lines::run_camera(int clock) {
  const int angles[3] = {angle(AngleYaw), angle(AnglePitch), angle(AngleFov)};
  decision_datapath_core& place = chip_.decision_datapath;
  decision_datapath_core::inputs to{};
  to.tracer_reset = true;
  to.nav_position = chip_.navigator.position_q;
  to.nav_room = chip_.navigator.room_q;
  vec3 dr1{};
  for (; !chip_.camera_unit.run(); ++clock) {
    dr1 = chip_.ray_stepper.dr1_q;
    to.descend = camera_clock(angles).descend;
  }
  place.clock(to, knobs_);
  chip_.subdivider.d1_q = place.decide(dr1, knobs_) & place.mask();
  return clock;
}

// Without the tracer's place and decision.
subdivider_core::outputs chip_lines::camera_clock(const int (&angles)[3]) {
  subdivider_core& sub = chip_.subdivider;
  subdivider_core::inputs in{};
  in.tracer_reset = true;
  const auto move = sub.comb(in, knobs_);
  const int src = chip_.camera_unit.source(false, move.step);
  const camera_unit_core::inputs cam{false, move.step, chip_.ray_stepper.dr2_q, angles[src], y_};
  const auto control = chip_.camera_unit.comb(cam, knobs_);
  in.idx_load = control.idx_load;
  in.idx_start = control.idx_start;
  in.i2_init = control.i2_init;
  chip_.ray_stepper.clock({control.load, control.load_zero, control.ext, control.ext_sign,
                           control.axis_mask, control.delta, control.copy, move.copy_sub, move.step,
                           move.neg, move.step_size, sub.idx2_q, true},
                          knobs_);
  sub.clock(in, move, knobs_);
  chip_.camera_unit.clock(cam, knobs_);
  return move;
}

line_counts chip_lines::trace(const line_setting& line, int clock) {
  if (line.observer) return trace_with<any_knobs, true>(chip_, beam_, line, clock);
  if (standard_) return trace_with<chip_knobs, false>(chip_, beam_, line, clock);
  if (scene_standard_) return trace_with<scene_knobs, false>(chip_, beam_, line, clock);
  if (only_limits_) return trace_with<limit_knobs, false>(chip_, beam_, line, clock);
  return trace_with<any_knobs, false>(chip_, beam_, line, clock);
}

// The clock in which the line ends: all units.
void chip_lines::last_clock() {
  frame_stats& stats = collector_.stats();
  chip_view view;
  const int uo = chip_.clock_video(true, knobs_, &view);
  if (options_.pins) pins_.push_back(static_cast<std::uint8_t>(uo));
  if (!visible_) return;
  ++stats.fifo_fill[view.fill];
  const bool starving = view.starving || !view.run;
  stats.starved_pixels += starving;
  stats.seen_starved_pixels += starving && !view.lock;
  const int colour = pixel_output_core::colour_of_pins(uo);
  pixels_.back() = static_cast<std::uint8_t>(colour);
  if (options_.observer) options_.observer->shown(y_, VisibleColumns - 1, 1, colour);
}

void chip_lines::count(const line_counts& c) {
  frame_stats& to = collector_.stats();
  to.clocks += raster_.size();
  if (!visible_) return;
  to.left_decisions += c.left;
  to.right_decisions += c.right;
  to.bisection_steps += c.bisect;
  to.adjust_steps += c.adjust;
  to.descents += c.descents;
  to.pushes += c.pushes;
  to.returns += c.returns;
  to.return_clocks += c.return_clocks;
  to.emits += c.emits;
  to.restarts += c.restarts;
  to.give_ups += c.give_ups;
  to.fifo_full_stalls += c.stalls;
  to.rooms_entered += c.rooms;
  to.merges += c.merges;
  to.sign_splits += c.sign_splits;
  to.seen_starved_pixels += c.seen_starved;
  to.camera_clocks.push_back(c.camera_clock);
  to.first_emit.push_back(c.first_emit);
  to.done_clock.push_back(c.done_clock);
  to.busy_clocks.push_back(c.clocks - c.stalls);
  to.stack_needed.push_back(c.stack_needed);
  const int busy = c.clocks - c.stalls, returning = c.return_clocks - c.stalls;
  to.add_line({c.camera_clock, c.left + c.right, c.bisect, c.adjust,
               busy - returning - c.decisions() - c.adjust, returning, c.stalls,
               raster_.size() - c.camera_clock - c.clocks});
}

// The pins of all clocks but the last.
void chip_lines::show_pins(const vga_timing_core& begin, const line_setting& line) {
  const auto& look = line.choice[0];
  for (int clock = 0; clock + 1 < raster_.size(); ++clock) {
    const auto t = raster_.at(clock, begin).comb({true, knobs_.speed}, knobs_.clocks_per_pixel);
    pins_.push_back(
        static_cast<std::uint8_t>(pixel_output_core::uo({indices_[clock],
                                                         false,
                                                         look.inverse,
                                                         t.active,
                                                         t.hsync_n,
                                                         t.vsync_n,
                                                         {},
                                                         look.palette,
                                                         look.colours,
                                                         pixel_output_core::is_odd(t.x2, t.y)},
                                                        knobs_)));
  }
}

}  // namespace racebeam
