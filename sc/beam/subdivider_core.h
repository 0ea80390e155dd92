// Behaviour of subdivider (subdivider.h), inlined into whatever runs it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <tuple>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/beam/codes.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Pixels of the step for a doubled distance `n` (contract 9.5): the power of two closest to n / 2,
/// ties up when n >= 0, down when n < 0; 1 where the distance is 0.
[[gnu::always_inline]] inline int closest_power_of_two(int n) {
  const int v = n < 0 ? -n - 1 : n;
  if (v < 3) return 1;
  const int top = 31 - __builtin_clz(v);
  return 1 << (top - 1 + (v >> (top - 1) & 1));
}

/// The largest power of two up to half of `width`, 2..1023.
[[gnu::always_inline]] inline int half_floor(int width) { return 1 << (30 - __builtin_clz(width)); }

/// Behaviour of subdivider.
struct subdivider_core {
  int state_q = StateLeft;
  int i1_q = 0, i2_q = 0;
  int lo_q = 0, hi_q = 0;  // bisection bounds
  int idx2_q = 0;          // pixel of dr2
  int d1_q = 0;            // decision at the left end: {signs, bit}
  bool emit_done_q = false;
  bool was_return_q = false;
  bool line_done_q = false;
  int sp_q = 0, sd_q = 0;  // interval stack: next free place, valid entries

  struct inputs {
    bool tracer_reset, idx_load;
    int idx_start, i2_init;
    int dec, mask;  // {sign z, y, x, bit} of the selected end; bits that count
    bool wall, second;
    int tag;  // {portal, depth, level}
    bool starving, ack;
    int top_tag, top_i2;
    bool lock, consume;
  };

  /// The interval on offer to the FIFO is i1..i2.
  [[gnu::always_inline]] bool emit(const inputs& in, const knobs& k) const {
    return returning(in, k) && !emit_done_q && !line_done_q;
  }
  int len_m1() const { return (i2_q - i1_q) & 1023; }
  int signs() const { return d1_q >> 1; }

  /// What happens in this clock; `inputs::ack` must answer emit().
  struct outputs {
    bool step, neg;
    int step_size;
    bool copy_sub, push, descend, climb, restart;
    int cur;    // decision to descend with; 0 otherwise
    int leave;  // {leaves a face or past a portal's edge, decision}; 0 otherwise
    bool advance, returning;
    int next_state, next_i2, next_lo, next_hi;
  };
  outputs comb(const inputs& in, const knobs& k) const;
  void clock(const inputs& in, const outputs& o, const knobs& k);

  /// LEFT clocks in the lock effect that move idx2 over some pixels, the last of them with the
  /// beam's step, at once. They leave d1 as it is: a clock of the same kind has loaded it.
  void follow_beam(int pixels) {
    lo_q = 2 * (idx2_q + pixels - 1) & 1023;
    hi_q = 2 * i2_q & 1023;
    idx2_q = (idx2_q + pixels) & 1023;
  }
  bool operator==(const subdivider_core& other) const {
    const auto all = [](const subdivider_core& c) {
      return std::tie(c.state_q, c.i1_q, c.i2_q, c.lo_q, c.hi_q, c.idx2_q, c.d1_q, c.emit_done_q,
                      c.was_return_q, c.line_done_q, c.sp_q, c.sd_q);
    };
    return all(*this) == all(other);
  }

  /// A wall, or nothing but the hurry rule, ends the interval in this clock.
  [[gnu::always_inline]] bool hit(const inputs& in, const knobs& k) const {
    const bool accept = state_q != StateReturn && idx2_q == i2_q && !emit_done_q;
    return accept && (in.wall || (in.starving && len_m1() <= k.hurry_threshold));
  }
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    visit("state_q", 2, [this] { return state_q; });
    visit("i1_q", PixelBits, [this] { return i1_q; });
    visit("i2_q", PixelBits, [this] { return i2_q; });
    visit("lo_q", PixelBits, [this] { return lo_q; });
    visit("hi_q", PixelBits, [this] { return hi_q; });
    visit("idx2_q", PixelBits, [this] { return idx2_q; });
    visit("d1_q", 4, [this] { return d1_q; });
    visit("emit_done_q", 1, [this] { return emit_done_q; });
    visit("was_return_q", 1, [this] { return was_return_q; });
    visit("line_done_q", 1, [this] { return line_done_q; });
    visit("sp_q", k.interval_stack_depth > 1 ? count_bits(k.interval_stack_depth) : 1,
          [this] { return sp_q; });
    visit("sd_q", count_bits(k.interval_stack_depth + 1), [this] { return sd_q; });
  }

 private:
  [[gnu::always_inline]] bool returning(const inputs& in, const knobs& k) const {
    return !in.tracer_reset && (state_q == StateReturn || hit(in, k));
  }
};

[[gnu::always_inline]] inline subdivider_core::outputs subdivider_core::comb(const inputs& in,
                                                                             const knobs& k) const {
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
  const auto walk_to = [&](int target)
      __attribute__((always_inline)) {  // towards a pixel, by closest powers of two
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
      else if (k.bisection == BisectionFloor && width > 1) o.step_size = half_floor(width);
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

[[gnu::always_inline]] inline void subdivider_core::clock(const inputs& in, const outputs& o,
                                                          const knobs& k) {
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

}  // namespace racebeam
