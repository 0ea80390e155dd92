// Behaviour of divider_unit (divider_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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
    std::uint64_t rest = 0;  // of the numerator's magnitude: the next bit is bit 35
    std::uint32_t remainder = 0;
    int found = 0;  // the quotient's magnitude, low 24 bits
    bool minus = false;
    int quotient = 0;
  };
  bool start_q = false, done_q = false;
  int edges_q = 0;  // still to come
  int bits_q = 0;   // likewise, of the quotients
  int magnitude_q = 0;
  std::array<lane, 3> lanes_q;

  struct inputs {
    bool rst_n, start;
    std::array<std::int64_t, 3> numerator;
    int denominator;
  };

  vec3 quotient() const { return {lanes_q[0].quotient, lanes_q[1].quotient, lanes_q[2].quotient}; }
  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    return in.rst_n && in.start == start_q && edges_q == 0 && (in.start || !done_q);
  }
  void clock(const inputs& in, const sphere_knobs& k) {
    if (!in.rst_n) {
      *this = {};
      return;
    }
    if (!in.start) {
      start_q = done_q = false;
      edges_q = 0;
      return;
    }
    if (!start_q) {
      magnitude_q = in.denominator < 0 ? -in.denominator : in.denominator;
      bits_q = NumeratorBits;
      edges_q = k.divide_clocks;
      for (int n = 0; n < 3; ++n) {
        const bool negative = in.numerator[n] < 0;
        lanes_q[n].rest = static_cast<std::uint64_t>(negative ? -in.numerator[n] : in.numerator[n]);
        lanes_q[n].remainder = 0;
        lanes_q[n].found = 0;
        lanes_q[n].minus = negative != (in.denominator < 0);
      }
    }
    start_q = true;
    if (edges_q == 0) return;
    const int now = std::min(bits_q, (NumeratorBits + k.divide_clocks - 1) / k.divide_clocks);
    for (lane& l : lanes_q)
      for (int n = 0; n < now; ++n) bit(l);
    bits_q -= now;
    if (--edges_q) return;
    for (lane& l : lanes_q) {
      const int size = magnitude_q == 0 ? 0x7fffff : l.found;
      l.quotient = wrap24(l.minus ? -size : size);
    }
    done_q = true;
  }

  /// Calls visit(name, bits, read) for each register; the RTL has a lane in one.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("start_q", 1, [this] { return start_q; });
    visit("done_q", 1, [this] { return done_q; });
    visit("edges_q", 6, [this] { return edges_q; });
    visit("bits_q", 6, [this] { return bits_q; });
    visit("magnitude_q", SphereBits, [this] { return magnitude_q; });
    for (int n = 0; n < 3; ++n) {
      const lane* l = &lanes_q[n];
      visit(element("rest_q", n), NumeratorBits, [l] { return l->rest; });
      visit(element("remainder_q", n), SphereBits + 1, [l] { return l->remainder; });
      visit(element("found_q", n), SphereBits, [l] { return l->found; });
      visit(element("minus_q", n), 1, [l] { return l->minus; });
      visit(std::string("quotient_") + "xyz"[n] + "_q", SphereBits, [l] { return l->quotient; });
    }
  }

 private:
  void bit(lane& l) {
    l.remainder = l.remainder << 1 | static_cast<std::uint32_t>(l.rest >> (NumeratorBits - 1) & 1);
    l.rest = l.rest << 1 & ((std::uint64_t{1} << NumeratorBits) - 1);
    const bool fits = l.remainder >= static_cast<std::uint32_t>(magnitude_q);
    if (fits) l.remainder -= static_cast<std::uint32_t>(magnitude_q);
    l.found = (l.found << 1 | fits) & low_bits(SphereBits);
  }
};

}  // namespace racebeam
