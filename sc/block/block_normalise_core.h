// Behaviour of block_normalise (block_normalise.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/fixed_point.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"
#include "sc/block/numbers.h"

namespace racebeam {

struct block_normalise_core {
  int step_q = 0;  // clocks that are over; 0: idle, too
  int part_q = 0;  // of a step of Newton's
  int aa_q = 0, x_q = 0, t_q = 0;

  struct inputs {
    bool rst_n, start;
    vec3 v;
  };
  struct outputs {
    vec3 unit;
    bool done;
  };

  /// In the second clock.
  bool small() const { return step_q == 1 && aa_q < BlockSmallLength2; }
  static constexpr int last_step(const block_knobs& k) { return 2 + 3 * k.newton_steps; }
  outputs comb(const vec3& v, const block_knobs& k) const {
    if (step_q != last_step(k)) return {};
    return {imul(v, x_q), true};
  }
  void clock(const inputs& in, const block_knobs& k) {
    if (step_q == 0) {
      if (in.start) aa_q = inorm2(in.v);
    } else if (step_q == 1) {
      x_q = inverse_root_estimate(aa_q);
    } else if (step_q < last_step(k)) {
      newton();
    }
    if (!in.rst_n) {
      step_q = part_q = 0;
    } else if (step_q != 0 || in.start) {
      const bool newton_now = step_q > 1 && step_q < last_step(k);
      part_q = newton_now && part_q < 2 ? part_q + 1 : 0;
      step_q = step_q == last_step(k) ? 0 : step_q + 1;
    }
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("step_q", 4, [this] { return step_q; });
    visit("part_q", 2, [this] { return part_q; });
    visit("aa_q", BlockBits, [this] { return aa_q; });
    visit("x_q", BlockBits, [this] { return x_q; });
    visit("t_q", BlockBits, [this] { return t_q; });
  }

 private:
  void newton() {
    if (part_q == 0) t_q = imul(x_q, x_q);
    else if (part_q == 1) t_q = imul(t_q, aa_q >> 1);
    else x_q = imul(x_q, block_difference(0x180000, t_q));
  }
};

}  // namespace racebeam
