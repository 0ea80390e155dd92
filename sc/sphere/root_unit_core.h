// Behaviour of root_unit (root_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "sc/base/probe.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

struct root_unit_core {
  static constexpr int Digits = 22, RootBits = 18;  // the first four are 0

  bool start_q = false, done_q = false;
  bool load_q = false;       // the radicand is loaded at the next edge
  int digits_q = 0;          // still to come
  std::uint32_t rest_q = 0;  // of the radicand: the next two bits on top
  std::uint32_t remainder_q = 0;
  int found_q = 0, root_q = 0;

  struct inputs {
    bool rst_n, start;
    int radicand;
  };

  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    return in.rst_n && in.start == start_q && !load_q && digits_q == 0 && (in.start || !done_q);
  }
  void clock(const inputs& in, const sphere_knobs& k) {
    if (!in.rst_n) {
      *this = {};
      return;
    }
    if (!in.start) {
      start_q = done_q = load_q = false;
      digits_q = 0;
      return;
    }
    if (load_q) {
      load_q = false;
      rest_q = static_cast<std::uint32_t>(in.radicand);
      remainder_q = 0;
      found_q = 0;
      digits_q = Digits;
    } else if (digits_q) {
      const int now = std::min(digits_q, k.root_bits_per_clock);
      for (int n = 0; n < now; ++n) digit();
      digits_q -= now;
      if (digits_q == 0) {
        root_q = found_q;
        done_q = true;
      }
    }
    if (!start_q) load_q = true;
    start_q = true;
  }

  /// Calls visit(name, bits, read) for each register; the RTL counts steps instead of digits.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("start_q", 1, [this] { return start_q; });
    visit("done_q", 1, [this] { return done_q; });
    visit("load_q", 1, [this] { return load_q; });
    visit("digits_q", 5, [this] { return digits_q; });
    visit("rest_q", 32, [this] { return rest_q; });
    visit("remainder_q", RootBits + 3, [this] { return remainder_q; });
    visit("found_q", RootBits, [this] { return found_q; });
    visit("root_q", SphereBits, [this] { return root_q; });
  }

 private:
  void digit() {
    remainder_q = remainder_q << 2 | rest_q >> 30;
    rest_q <<= 2;
    const std::uint32_t trial = static_cast<std::uint32_t>(found_q) << 2 | 1;
    const bool fits = remainder_q >= trial;
    if (fits) remainder_q -= trial;
    found_q = found_q << 1 | fits;
  }
};

}  // namespace racebeam
