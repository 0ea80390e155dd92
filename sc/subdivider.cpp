// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/subdivider.h"

#include <algorithm>

namespace racebeam {

subdivider_core::outputs subdivider_core::comb(const inputs& in, const knobs& k) const {
  outputs o;
  const bool hit_now = hit(in, k);
  o.returning = returning(in, k);
  const bool pending = emit(in, k) && !in.ack;
  const bool need_climb = o.returning && (in.tag != in.top_tag || in.second);
  o.climb = need_climb && !pending;
  const bool enable = !need_climb && !in.second && !pending;
  o.restart = sd_q == 0 && state_q == StateReturn && o.returning && !pending;
  o.advance = (enable && !hit_now) || o.restart;
  o.copy_sub = false;

  // Moves A to E of contract 9.4.
  bool want_step = false, force = false, want_descend = false, push = false;
  o.neg = false;
  o.step_size = 1;
  o.next_state = StateLeft;
  o.next_i2 = i2_q;
  o.next_lo = lo_q;
  o.next_hi = hi_q;
  const auto walk_to = [&](int target) {  // towards a pixel, by closest powers of two
    o.next_lo = 2 * idx2_q;
    o.next_hi = 2 * target;
    const int distance = o.next_hi - o.next_lo;
    if (distance == 0) return false;
    want_step = force = true;
    o.neg = distance < 0;
    o.step_size = closest_power_of_two(distance);
    return true;
  };
  const bool agree = ((d1_q ^ in.dec) & in.mask) == 0;
  if (o.returning) {
    o.next_i2 = in.top_i2;
    if (state_q != StateReturn) {
      want_step = force = true;
    } else {
      o.copy_sub = !was_return_q;
      walk_to(in.top_i2);
    }
  } else if (in.tracer_reset || state_q == StateLeft) {
    if (!walk_to(i2_q)) {
      if (i1_q == i2_q) want_descend = true;
      else o.next_state = StateRight;
    }
  } else if (state_q == StateRight && agree) {
    want_descend = true;
  } else {
    if (state_q == StateRight) {
      o.next_lo = i1_q;
      o.next_hi = i2_q;
    } else {
      (agree ? o.next_lo : o.next_hi) = idx2_q;
    }
    const int width = o.next_hi - o.next_lo;
    o.neg = !agree;
    if (width == 1) {
      push = want_descend = true;
      o.next_i2 = o.next_lo;
      want_step = !agree;
      o.neg = true;
    } else {
      want_step = true;
      o.next_state = StateBisect;
      if (k.bisection == BisectionMidpoint && width > 1)
        o.step_size = agree ? width / 2 : width - width / 2;
      else o.step_size = closest_power_of_two(width);
    }
  }
  o.step = want_step && (o.advance || force) && !o.restart;
  if (in.lock && !in.tracer_reset) {
    o.step = in.consume;
    o.neg = false;
    o.step_size = 1;
  }
  o.push = push && o.advance;
  o.descend = o.advance && want_descend && !o.returning;
  o.cur = !o.descend ? 0 : state_q == StateLeft ? in.dec : d1_q;
  const int level = in.tag & low_bits(LevelBits);
  const bool leaves = level == 7 || (level < 4 && (o.cur & 1) && k.portals_per_face > 1);
  o.leave = o.descend && leaves ? 2 | (o.cur & 1) : 0;
  return o;
}

void subdivider_core::clock(const inputs& in, const outputs& o, const knobs& k) {
  const bool was_left = state_q == StateLeft, was_return = state_q == StateReturn;
  const bool last_pixel = i2_q == LastPixel;

  if (in.tracer_reset) i1_q = 0;
  else if (o.advance && o.returning) i1_q = (i2_q + 1) & 1023;

  const int entries = k.interval_stack_depth;
  if (in.tracer_reset || o.restart) {
    state_q = StateLeft;
    i2_q = in.i2_init;
    sp_q = sd_q = 0;
  } else if (o.advance) {
    state_q = o.next_state;
    i2_q = o.next_i2 & 1023;
    if (o.push) {
      sp_q = sp_q + 1 == entries ? 0 : sp_q + 1;
      sd_q = std::min(sd_q + 1, entries);
    } else if (o.returning) {
      sp_q = sp_q == 0 ? entries - 1 : sp_q - 1;
      sd_q -= 1;
    }
  } else if (o.returning) {
    state_q = StateReturn;
  }

  if (in.idx_load) idx2_q = in.idx_start;
  else if (o.step) idx2_q = (o.neg ? idx2_q - o.step_size : idx2_q + o.step_size) & 1023;

  const int taken = o.advance && was_left ? in.mask : 0;
  d1_q = (in.dec & taken) | (in.tracer_reset ? 0 : d1_q & ~taken);

  if (in.tracer_reset) {
    emit_done_q = was_return_q = line_done_q = false;
    return;
  }
  if (o.advance) {
    lo_q = o.next_lo & 1023;
    hi_q = o.next_hi & 1023;
  }
  emit_done_q = (emit_done_q && !o.advance) || in.ack;
  line_done_q |= last_pixel && o.returning && in.ack;
  was_return_q = was_return;
}

subdivider::subdivider(const sc_core::sc_module_name& name, const knobs& k)
    : subdivider_pins(name), knobs_(k) {
  SC_HAS_PROCESS(subdivider);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << tracer_reset_i << dec_i << mask_i << wall_i << second_i << tag_i << starving_i
            << ack_i << top_tag_i << top_i2_i << lock_i;
}

void subdivider::seq() {
  in_.idx_load = idx_load_i.value();
  in_.idx_start = idx_start_i.value();
  in_.i2_init = i2_init_i.value();
  core_.clock(in_, out_, knobs_);
  state_o.drive(core_.state_q);
  idx2_o.drive(core_.idx2_q);
  i2_o.drive(core_.i2_q);
  len_m1_o.drive(core_.len_m1());
  ray_signs_o.drive(core_.signs());
  sp_o.drive(core_.sp_q);
  sd_o.drive(core_.sd_q);
  line_done_o.drive(core_.line_done_q);
  drive();  // with the inputs of before the edge; again when one of them changes
}

void subdivider::drive() {
  in_.tracer_reset = tracer_reset_i.value();
  in_.dec = dec_i.value();
  in_.mask = mask_i.value();
  in_.wall = wall_i.value();
  in_.second = second_i.value();
  in_.tag = tag_i.value();
  in_.starving = starving_i.value();
  in_.ack = ack_i.value();
  in_.top_tag = top_tag_i.value();
  in_.top_i2 = top_i2_i.value();
  in_.lock = lock_i.value();
  in_.consume = consume_i.value();
  emit_o.drive(core_.emit(in_, knobs_));
  out_ = core_.comb(in_, knobs_);
  step_o.drive(out_.step);
  neg_o.drive(out_.neg);
  step_size_o.drive(out_.step_size);
  copy_sub_o.drive(out_.copy_sub);
  push_en_o.drive(out_.push);
  descend_o.drive(out_.descend);
  climb_o.drive(out_.climb);
  cur_o.drive(out_.cur);
  leave_o.drive(out_.leave);
  restart_o.drive(out_.restart);
}

void subdivider::comb() {
  drive();
  if (!in_.lock) return;
  // The beam's clock matters only while it drives the steps.
  if (lock_events_.size() == 0)
    lock_events_ = consume_i->value_changed_event() | tracer_reset_i->value_changed_event() |
                   dec_i->value_changed_event() | mask_i->value_changed_event() |
                   wall_i->value_changed_event() | second_i->value_changed_event() |
                   tag_i->value_changed_event() | starving_i->value_changed_event() |
                   ack_i->value_changed_event() | top_tag_i->value_changed_event() |
                   top_i2_i->value_changed_event() | lock_i->value_changed_event();
  next_trigger(lock_events_);
}

}  // namespace racebeam
