// The body of line_tracer.h, for the files that instantiate it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/tlm/line_tracer.h"
#include "sc/beam/tlm/tracer_round.h"

namespace racebeam {

template <class Knobs, bool Pattern, bool Watch>
line_counts trace_line(chip_core& chip, line_beam& beam, const line_setting& line, int t) {
  const knobs& k = Knobs::of(line.k);
  subdivider_core sub = chip.subdivider;
  decision_datapath_core place = chip.decision_datapath;
  ray_stepper_core rays = chip.ray_stepper;
  stacks_core& stacks = chip.stacks;
  const vec3 ddr = chip.camera_unit.ddr_q;
  const int begin = t, end = line.raster.size() - 1;
  int starves_from = beam.starves_from();
  line_counts counts, at_done;
  counts.camera_clock = t;
  frame_stats* histograms = &line.histograms;
  int walk = 0, stack = 0, colour_before = 0;
  tracer_round round;
  bool given_up = false;
  bool behind = false;
  int column = line.raster.columns_before[t];  // Pattern: the next to be shown
  const room_row* here = &scene_rom_core::row(line.rooms, place.room_q & line.room_mask);
  if constexpr (Watch) {  // so that without it the compiler's choices stay as they are
    line.observer->started(line.y, t);
    line.rooms_told->tell(*line.observer, line.y, t, place);
  }

  // Pattern: the next column, now.
  const auto show_column = [&](const sequencer_outputs& choice) {
    if (line.row) {
      beam.advance(line.raster.column_clock[column]);
      counts.seen_starved += !choice.lock && beam.starving();
      int colour;
      if (choice.lock) {
        colour = pixel_output_core::colour({0, true, choice.inverse, true, true, true, rays.dr2_q,
                                            choice.palette, choice.colours, false},
                                           line.k);
      } else {
        colour = line.colours[(column ^ line.y) & 1][beam.display()];
      }
      line.row[column] = static_cast<std::uint8_t>(colour);
      if (Watch) line.observer->shown(line.y, column, 1, colour);
    }
    ++column;
  };
  // Clocks without the lock effect are left out.
  const auto leave_out = [&](int clocks) {
    t += clocks;
    if (Pattern)
      while (column < VisibleColumns && line.raster.column_clock[column] < t)
        show_column(line.choice[0]);
  };
  bool locked = false;  // the effect held in some clock of this round

  const auto clock = [&](auto of_state) __attribute__((always_inline)) {
    constexpr int State = decltype(of_state)::value;
    if (sub.state_q != State) __builtin_unreachable();
    constexpr bool InReturn = State == StateReturn;

    const bool consume =
        Pattern && column < VisibleColumns && line.raster.column_clock[column] == t;
    const sequencer_outputs& choice = line.choice[Pattern && shows_pattern(rays.dr2_q[1], k)];

    if (Pattern && consume) show_column(choice);

    // The decision.
    const auto& top = stacks.top(sub.sp_q, k);
    subdivider_core::inputs in{};
    in.i2_init = LastPixel;
    if (!InReturn) in.dec = place.decide(State == StateLeft ? rays.dr1_q : rays.dr2_q, k);
    in.mask = place.mask();
    in.wall = place.wall_q;
    in.second = place.second_q;
    in.tag = place.tag();
    in.starving = t >= starves_from;
    in.top_tag = top.tag;
    in.top_i2 = top.i2;
    in.lock = Pattern && choice.lock;
    in.consume = consume;
    locked |= in.lock;

    // The interval on offer.
    const bool emit = sub.emit(in, k);
    if (__builtin_expect(emit, false)) {
      const int value = pixel_output_core::value(place.hit_face_q, sub.signs(), line.y & 1,
                                                 choice.shading_b, in.starving, k);
      in.ack = beam.offer(t, sub.len_m1(), value);
      if (!InReturn) {
        ++counts.returns;
        given_up = !in.wall;
        if (Watch) behind = place.is_behind();
        counts.give_ups += given_up;
      }
      if (in.ack) {
        starves_from = beam.starves_from();
        ++counts.emits;
        counts.merges += value == colour_before;
        colour_before = value;
        if (!given_up) add_slack(histograms->slack, line.raster, t, sub.i1_q, sub.i2_q);
        if (counts.first_emit < 0) counts.first_emit = t;
        if (Watch)
          line.observer->interval({line.y, t, sub.i1_q, sub.i2_q, value & IndexMask, place.room_q,
                                   place.depth_q, place.hit_face_q, behind, given_up,
                                   counts.decisions()});
      } else {
        ++counts.stalls;
      }
    }

    // The move, and what is counted of it.
    const auto move = sub.comb(in, k);
    ++histograms->stack_depth[sub.sd_q];
    if (InReturn || emit) {
      ++counts.return_clocks;
      walk = 0;
      stack = move.restart ? 0 : stack - move.advance;
    } else if (State == StateLeft && sub.idx2_q != sub.i2_q) {
      counts.adjust += !in.second;
      ++walk;
    } else if (!in.second) {
      ++(State == StateLeft ? counts.left : State == StateRight ? counts.right : counts.bisect);
      if (State == StateLeft) {
        ++bin_of(histograms->walk_steps, walk);
        walk = 0;
      }
      if (State == StateRight) counts.sign_splits += ((sub.d1_q ^ in.dec) & in.mask & ~1) != 0;
    }
    if (move.descend) {
      ++counts.descents;
      counts.rooms += place.level_q == 7;
      if (move.push) {
        ++counts.pushes;
        counts.stack_needed = std::max(counts.stack_needed, ++stack);
      }
    }

    // The room.
    decision_datapath_core::inputs to{};
    to.restart = move.restart;
    to.descend = move.descend;
    to.climb = move.climb;
    to.in_return = InReturn;
    to.cur = move.cur;
    to.leave = move.leave;
    to.signs = sub.signs();
    to.top_tag = top.tag;
    to.interlace = line.interlace;
    to.half_size = here->half_size;
    to.position = here->position;
    if (move.restart) {
      to.nav_position = chip.navigator.position_q;
      to.nav_room = chip.navigator.room_q;
    }
    const bool asks_edges =
        k.skip_shared_edges == SharedEdgesTable && (move.descend || place.second_q);
    if (move.climb || move.leave || asks_edges) {
      to.face_read = stacks.face(place.depth_q, k);
      const auto look = place.look(to, k);
      const auto beyond =
          scene_rom_core::look(line.rooms, place.room_q & line.room_mask, look.axis,
                               bit_of(look.signs, look.axis), look.portal, look.way);
      to.neighbour = beyond.room;
      to.back = beyond.back;
      to.edges = beyond.edges;
    }

    // The edge.
    stacks.clock({move.push, in.tag, sub.i2_q, sub.sp_q, place.face_write(to), place.face_code(),
                  place.depth_q},
                 k);
    place.clock(to, k);
    if (move.climb || move.leave || move.restart)
      here = &scene_rom_core::row(line.rooms, place.room_q & line.room_mask);
    ray_stepper_core::inputs step{};
    step.delta = ddr;
    step.copy_sub = move.copy_sub;
    step.step = move.step;
    step.neg = move.neg;
    step.step_size = move.step_size;
    step.idx2 = sub.idx2_q;
    rays.clock(step, k);
    const bool was_done = sub.line_done_q;
    if (Watch && move.restart && !was_done && sub.i2_q != LastPixel)
      line.observer->restart(line.y, t, sub.i2_q + 1);
    if (move.restart) counts.restarts += sub.i2_q != LastPixel;
    sub.clock(in, move, k);
    ++t;
    if constexpr (Watch)
      if (!sub.line_done_q && t < end) line.rooms_told->tell(*line.observer, line.y, t, place);

    // What may be left out.
    if (emit) {
      const bool still = sub.state_q == StateReturn && sub.was_return_q && sub.idx2_q == top.i2 &&
                         !place.second_q && !place.wall_q && !place.descend_q;
      if (!in.lock && !in.ack && still) {
        const int left_out = std::min(beam.offer_again(), end) - t;
        counts.stalls += left_out;
        counts.return_clocks += left_out;
        histograms->stack_depth[sub.sd_q] += left_out;
        leave_out(left_out);
      }
      if (sub.line_done_q) {
        counts.clocks = t - begin;
        if (t < end) counts.done_clock = t;
        at_done = counts;
        histograms = &line.unseen;
        if (!Pattern && line.apart) t = end;
      }
    }
    if (was_done && move.restart) {
      if (locked) round.clock = -1;
      locked = false;
      leave_out(repeated_clocks(round, {sub, place, rays, stacks, t}, starves_from, end));
    }
  };

  // In the lock effect dr2 goes with the beam: whole pixels at once, once all else has settled.
  bool settled = false;
  const auto follow_beam = [&] {
    while (t < end) {
      const sequencer_outputs& choice = line.choice[shows_pattern(rays.dr2_q[1], k)];
      if (!choice.lock || sub.idx2_q == sub.i2_q || column >= VisibleColumns) return;
      const int next = line.raster.column_clock[column] + 1;
      if (next > end) return;
      show_column(choice);
      ray_stepper_core::inputs step{};
      step.delta = ddr;
      step.step = true;
      step.step_size = 1;
      step.idx2 = sub.idx2_q;
      rays.clock(step, k);
      sub.follow_beam(1);
      counts.adjust += next - t;
      histograms->stack_depth[sub.sd_q] += next - t;
      walk += next - t;
      t = next;
    }
  };

  while (t < end) {
    if (Pattern && settled) follow_beam();
    if (Pattern && t >= end) break;
    const int adjusted = counts.adjust;
    switch (sub.state_q) {
      case StateLeft: clock(std::integral_constant<int, StateLeft>()); break;
      case StateRight: clock(std::integral_constant<int, StateRight>()); break;
      case StateBisect: clock(std::integral_constant<int, StateBisect>()); break;
      default: clock(std::integral_constant<int, StateReturn>()); break;
    }
    settled = counts.adjust != adjusted && sub.state_q == StateLeft;
  }

  chip.subdivider = sub;
  chip.decision_datapath = place;
  chip.ray_stepper = rays;
  if (sub.line_done_q) return at_done;
  counts.clocks = end - begin;
  return counts;
}

}  // namespace racebeam
