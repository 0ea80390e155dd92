// Behaviour of root_unit (root_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

struct root_unit_core {
  static constexpr int Digits = 22, RootBits = 18;  // the first four are 0

  bool start_q = false, done_q = false;
  int step_q = 0;                 // 0: idle, 1: loads, from 2 on: digits
  std::uint32_t rest_q = 0;       // of the radicand: the next two bits on top
  std::uint32_t remainder_q = 0;  // the last one, of 19 bits, is not asked for
  int found_q = 0, root_q = 0;

  struct inputs {
    bool rst_n, start;
    int radicand;
  };

  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    return in.rst_n && in.start == start_q && step_q == 0 && (in.start || !done_q);
  }
  void clock(const inputs& in, const sphere_knobs& k) {
    const int rounds = (Digits + k.root_bits_per_clock - 1) / k.root_bits_per_clock;
    const int last_step = rounds + 1;
    if (in.start && step_q == 1) {
      rest_q = static_cast<std::uint32_t>(in.radicand);
      remainder_q = 0;
      found_q = 0;
    } else if (in.start && step_q != 0) {
      const int rest = Digits - (rounds - 1) * k.root_bits_per_clock;
      for (int n = 0; n < (step_q == last_step ? rest : k.root_bits_per_clock); ++n) digit();
    }
    if (!in.rst_n) {  // of the digits nothing
      start_q = done_q = false;
      step_q = root_q = 0;
      return;
    }
    if (!in.start) {
      step_q = 0;
      done_q = false;
    } else if (step_q == 0) {
      step_q = start_q ? 0 : 1;
    } else if (step_q == last_step) {
      step_q = 0;
      done_q = true;
      root_q = found_q;
    } else {
      ++step_q;
    }
    start_q = in.start;
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("start_q", 1, [this] { return start_q; });
    visit("done_q", 1, [this] { return done_q; });
    visit("step_q", 5, [this] { return step_q; });
    visit("rest_q", 32, [this] { return rest_q; });
    visit("remainder_q", RootBits, [this] { return remainder_q; });
    visit("found_q", RootBits, [this] { return found_q; });
    visit("root_q", RootBits, [this] { return root_q; });
  }

 private:
  void digit() {
    std::uint32_t remainder = remainder_q << 2 | rest_q >> 30;
    rest_q <<= 2;
    const std::uint32_t trial = static_cast<std::uint32_t>(found_q) << 2 | 1;
    const bool fits = remainder >= trial;
    if (fits) remainder -= trial;
    remainder_q = remainder & low_bits(RootBits);
    found_q = found_q << 1 | fits;
  }
};

}  // namespace racebeam
