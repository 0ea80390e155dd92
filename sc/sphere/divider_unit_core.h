// Behaviour of divider_unit (divider_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/numbers.h"

namespace racebeam {

struct divider_unit_core {
  struct lane {
    std::uint64_t rest = 0;  // of the numerator's magnitude, zeros before it: the next bit on top
    int remainder = 0;
    int found = 0;  // the quotient's magnitude, low 24 bits
  };
  bool done_q = false;
  int step_q = 0;         // clocks of the division that are over; 0: idle too
  int denominator_q = 0;  // its magnitude
  int minus_q = 0;        // z, y, x
  std::array<lane, 3> lanes_q;
  vec3 quotient_q{};

  struct inputs {
    bool rst_n, start;
    std::array<std::int64_t, 3> numerator;
    int denominator;
  };

  const vec3& quotient() const { return quotient_q; }
  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const { return in.rst_n && in.start == done_q && step_q == 0; }
  void clock(const inputs& in, const sphere_knobs& k) {
    const bool running = in.start && !done_q, rises = running && step_q == 0;
    if (rises) load(in);
    if (running && step_q < busy_clocks(k))
      for (lane& l : lanes_q)
        for (int n = 0; n < step_bits(k); ++n) bit(l, rest_bits(k));
    if (!in.rst_n) {  // of the division nothing
      done_q = false;
      step_q = 0;
      quotient_q = {};
      return;
    }
    const bool ends = running && step_q == k.divide_clocks - 1;
    step_q = running ? step_q + 1 : 0;
    done_q = in.start && (ends || done_q);
    if (!ends) return;
    for (int n = 0; n < 3; ++n) {
      const int size = denominator_q == 0 ? 0x7fffff : lanes_q[n].found;
      quotient_q[n] = wrap24(minus_q >> n & 1 ? -size : size);
    }
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const sphere_knobs& k) const {
    visit("done_q", 1, [this] { return done_q; });
    visit("step_q", 6, [this] { return step_q; });
    visit("denominator_q", SphereBits, [this] { return denominator_q; });
    visit("minus_q", 3, [this] { return minus_q; });
    for (int n = 0; n < 3; ++n) {
      const lane* l = &lanes_q[n];
      const auto name = [n](const char* stem) { return std::string(stem) + "_" + "xyz"[n] + "_q"; };
      visit(name("rest"), rest_bits(k), [l] { return l->rest; });
      visit(name("remainder"), SphereBits, [l] { return l->remainder; });
      visit(name("found"), SphereBits, [l] { return l->found; });
      visit(name("quotient"), SphereBits, [this, n] { return quotient_q[n]; });
    }
  }

 private:
  static int step_bits(const sphere_knobs& k) {
    return (NumeratorBits + k.divide_clocks - 1) / k.divide_clocks;
  }
  /// The clocks that divide; those after them are idle.
  static int busy_clocks(const sphere_knobs& k) {
    return (NumeratorBits + step_bits(k) - 1) / step_bits(k);
  }
  static int rest_bits(const sphere_knobs& k) { return busy_clocks(k) * step_bits(k); }

  void load(const inputs& in) {
    const auto size = [](std::int64_t value) { return value < 0 ? -value : value; };
    denominator_q = static_cast<int>(size(in.denominator));
    minus_q = 0;
    for (int n = 0; n < 3; ++n) {
      lanes_q[n] = {static_cast<std::uint64_t>(size(in.numerator[n])), 0, 0};
      if ((in.numerator[n] < 0) != (in.denominator < 0)) minus_q |= 1 << n;
    }
  }
  void bit(lane& l, int rest_bits) const {
    const int next = static_cast<int>(l.rest >> (rest_bits - 1) & 1);
    l.remainder = (l.remainder << 1 | next) & low_bits(SphereBits);
    l.rest = raw_bits(l.rest << 1, rest_bits);
    const bool fits = l.remainder >= denominator_q;
    if (fits) l.remainder -= denominator_q;
    l.found = (l.found << 1 | fits) & low_bits(SphereBits);
  }
};

}  // namespace racebeam
