// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/line_watcher.h"

#include <utility>

#include "sc/beam/stats_collector.h"
#include "sc/beam/tlm/chip_lines.h"

namespace racebeam {

namespace {

int depth_of(int tag) { return tag >> LevelBits & low_bits(DepthBits); }
int level_of(int tag) { return tag & low_bits(LevelBits); }

/// What the conductor chooses in a clock of a visible line.
sequencer_outputs choices(const chip_core& chip, const knobs& k) {
  const sequencer_inputs in{true, false, chip.camera_unit.run(), chip.ray_stepper.dr2_q[1]};
  return chip.program ? chip.timeline.comb(in, *chip.program, k) : chip.sequencer.comb(in, k);
}

/// Contract 17.4: the index of the ray pattern.
int pattern_index(const vec3& dr, const knobs& k) {
  const auto bits = [&](int axis, int low) {
    return rescaled(dr[axis], k.dr_bits, DrBits) >> low & 3;
  };
  return (bits(0, 5) | bits(2, 4)) & bits(1, 6);
}

/// Where the ray ends: how many rooms of the way it is sure to have entered, and why it ends.
struct Ending {
  IntervalEnd end;
  int rooms;
};

Ending ending(const decision_datapath_core& d, const knobs& k) {
  const bool asks_opening = d.depth_q > 0 && d.level_q < 4;
  if (!d.wall_q) return {IntervalEnd::GivenUp, asks_opening ? d.depth_q : d.depth_q + 1};
  if (d.depth_q > k.room_depth_limit()) return {IntervalEnd::TooDeep, d.depth_q};
  if (d.level_q != 7) return {IntervalEnd::Missed, d.depth_q};
  return {d.second_q ? IntervalEnd::TooDeep : IntervalEnd::Solid, d.depth_q + 1};
}

}  // namespace

LineWatcher::LineWatcher(chip_core& chip, const knobs& k) : chip_(chip), knobs_(k) {}

LineStory LineWatcher::watch(const std::vector<int>& columns) {
  story_ = {};
  story_.frame = chip_.frame();
  story_.y = chip_.vga_timing.v_pos_q;
  story_.shading_b = choices(chip_, knobs_).shading_b;
  story_.dithering = knobs_.dithering;
  clock_ = next_ = 0;
  column_ = step_begin_ = 0;
  for (bool last = false; !last; ++clock_) {
    const chip_core before = chip_;
    chip_view view;
    const int uo = chip_.clock_video(true, knobs_, &view);
    if (view.run && !view.line_done && !view.line_end) observe_tracer(before, view);
    if (column_ < columns.size() && clock_ == columns[column_]) show(before, uo);
    keep_way();
    last = view.line_end;
  }
  if (story_.tracer_begin >= 0 && next_ <= LastPixel) {
    TracedInterval rest{};
    rest.first = next_;
    rest.last = LastPixel;
    rest.end = IntervalEnd::Never;
    rest.clock = rest.axis = -1;
    rest.behind = SolidRoom;
    rest.step_begin = step_begin_;
    rest.step_end = story_.steps.size();
    story_.intervals.push_back(rest);
  }
  return std::move(story_);
}

// Between the halves of a room change the room is already the next one, but not the depth.
void LineWatcher::keep_way() {
  const decision_datapath_core& d = chip_.decision_datapath;
  if (d.second_q) return;
  way_[d.depth_q] = {d.room_q, d.face_q, bit_of(chip_.subdivider.signs(), d.face_q)};
}

void LineWatcher::observe_tracer(const chip_core& before, const chip_view& v) {
  const subdivider_core& s = before.subdivider;
  const decision_datapath_core& d = before.decision_datapath;
  const subdivider_core& after = chip_.subdivider;
  if (story_.tracer_begin < 0) story_.tracer_begin = clock_;
  const bool left = v.state == StateLeft, in_return = v.state == StateReturn;
  if (v.emit && !in_return) offer(before, v);
  std::vector<TracerStep>& steps = story_.steps;
  const bool waits = v.emit && !v.ack;
  if (waits && steps.size() > step_begin_ && steps.back().offers && !steps.back().emits &&
      in_return && steps.back().state == StateReturn) {
    ++steps.back().clocks;
    return;
  }
  TracerStep step{};
  step.clock = clock_;
  step.clocks = 1;
  step.state = v.state;
  step.first = s.i1_q;
  step.last = v.i2;
  step.idx2 = v.idx2;
  step.room = d.room_q;
  step.depth = depth_of(v.tag);
  step.level = level_of(v.tag);
  step.face = d.face_q;
  step.y_first = d.dom_q;
  step.second = v.second;
  step.decision = is_decision(v);
  step.walks = left && !v.second && !v.emit && v.idx2 != v.i2;
  if (step.decision) {
    const int mask = d.mask();
    const int dec = d.decide(left ? before.ray_stepper.dr1_q : before.ray_stepper.dr2_q, knobs_);
    step.answer = mask == 1 ? dec & 1 : dec >> 1;
    step.agrees = !left && ((dec ^ s.d1_q) & mask) == 0;
  }
  step.descends = v.descend;
  step.pushes = v.push;
  step.finds_wall = (v.descend || v.second) && !v.wall && chip_.decision_datapath.wall_q;
  step.offers = v.emit;
  step.emits = v.emit && v.ack;
  step.restarts = v.restart;
  const decision_datapath_core& moved = chip_.decision_datapath;
  const bool enters = d.second_q && d.descend_q;  // goes before a climb
  step.climbs = (in_return || v.emit) && !v.restart && !waits && !enters &&
                (moved.depth_q != d.depth_q || moved.level_q != d.level_q ||
                 moved.second_q != d.second_q || moved.portal_q != d.portal_q);
  step.pops = in_return && !v.restart && after.state_q == StateLeft;
  steps.push_back(step);
  if (step.emits) take(before, v);
}

// The first clock of a return: the datapath still stands where the interval ended.
void LineWatcher::offer(const chip_core& before, const chip_view& v) {
  const decision_datapath_core& d = before.decision_datapath;
  const Ending where = ending(d, knobs_);
  pending_ = {};
  pending_.end = where.end;
  pending_.depth = depth_of(v.tag);
  pending_.level = level_of(v.tag);
  pending_.way.assign(way_.begin(), way_.begin() + where.rooms);
  const bool asks_opening = pending_.level < 4 && pending_.depth > 0;
  const bool opening =
      where.end == IntervalEnd::Missed || (where.end == IntervalEnd::GivenUp && asks_opening);
  pending_.behind = opening ? d.room_q : SolidRoom;
  pending_.axis = where.end == IntervalEnd::GivenUp ? -1 : d.hit_face_q;
  pending_.negative = pending_.axis >= 0 && bit_of(before.subdivider.signs(), pending_.axis);
}

void LineWatcher::take(const chip_core& before, const chip_view& v) {
  pending_.first = before.subdivider.i1_q;
  pending_.last = v.i2;
  pending_.clock = clock_;
  pending_.value = chip_.interval_fifo.head_value_q & IndexMask;
  pending_.starving = v.starving;
  pending_.step_begin = step_begin_;
  pending_.step_end = step_begin_ = story_.steps.size();
  story_.intervals.push_back(pending_);
  next_ = v.i2 + 1;
}

void LineWatcher::show(const chip_core& before, int uo) {
  const sequencer_outputs s = choices(before, knobs_);
  ShownColumn& column = story_.columns[column_++];
  column.clock = clock_;
  column.colour = pixel_output_core::colour_of_pins(uo);
  const bool odd = (column_ - 1 + story_.y) & 1;
  column.display = pixel_output_core::shown(before.interval_fifo.display(knobs_), odd);
  column.starving = before.interval_fifo.starving(knobs_);
  column.pattern = s.lock;
  column.inverse = s.inverse;
  column.index = s.lock ? pattern_index(before.ray_stepper.dr2_q, knobs_) : column.display;
  if (s.inverse) column.index ^= column.index >> 1;
  column.palette = s.palette;
  for (int i = 0; i < 4; ++i)
    column.colours[i] = pixel_output_core::colour(
        {i, false, false, true, true, true, {}, s.palette, s.colours, false}, knobs_);
  column.idx2 = before.subdivider.idx2_q;
  column.ray = before.ray_stepper.dr2_q;
}

LineStory line_story(int frame, int y, const knobs& k, const scene_program* program) {
  chip_lines lines({k, program, false, false, nullptr});
  lines.deposit(frame);
  while (lines.next_line() != y) lines.run_line();
  std::vector<int> columns;
  for (int column = 0; column < VisibleColumns; ++column)
    columns.push_back(lines.column_clock(column));
  return LineWatcher(lines.registers(), k).watch(columns);
}

}  // namespace racebeam
