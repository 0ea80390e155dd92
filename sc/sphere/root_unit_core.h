// Behaviour of root_unit (root_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

struct root_unit_core {
  static constexpr int Digits = 22, RootBits = 18;  // the first four are 0

  /// Digits of 0 come before those 18, so that all rounds are of root_bits_per_clock.
  struct schedule {
    int rounds, zeros;
    explicit schedule(const sphere_knobs& k)
        : rounds((Digits + k.root_bits_per_clock - 1) / k.root_bits_per_clock),
          zeros(rounds * k.root_bits_per_clock - RootBits) {}
    int last_step() const { return rounds + 1; }
    int rest_bits() const { return SphereBits + 2 * zeros; }
  };

  bool start_q = false, done_q = false;
  int step_q = 0;  // 0: idle, 1: loads, from 2 on: rounds
  std::uint32_t radicand_q = 0, remainder_q = 0;
  int taken_q = 0;  // digits of it, with the zeros before
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
    const schedule s(k);
    if (in.start && step_q == 1) {
      radicand_q = static_cast<std::uint32_t>(in.radicand);
      remainder_q = 0;
      taken_q = found_q = 0;
    } else if (in.start && step_q != 0) {
      for (int n = 0; n < k.root_bits_per_clock; ++n) digit(s.zeros);
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
    } else if (step_q == s.last_step()) {
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
  void each_register(Visit&& visit, const sphere_knobs& k) const {
    visit("start_q", 1, [this] { return start_q; });
    visit("done_q", 1, [this] { return done_q; });
    visit("step_q", 5, [this] { return step_q; });
    // As the RTL has it: what comes next on top.
    const schedule s(k);
    visit("rest_q", std::min(s.rest_bits(), 64),
          [this] { return 2 * taken_q < 64 ? std::uint64_t{radicand_q} << 2 * taken_q : 0; });
    const int found_bits = std::max(1, RootBits - k.root_bits_per_clock);
    visit("remainder_q", found_bits + 1, [this] { return remainder_q; });
    visit("found_q", found_bits, [this] { return found_q; });
    visit("root_q", RootBits, [this] { return root_q; });
  }

 private:
  void digit(int zeros) {
    const int shift = SphereBits - 2 - 2 * (taken_q++ - zeros);  // of its two bits
    const std::uint32_t bits = shift < SphereBits && shift >= 0 ? radicand_q >> shift & 3 : 0;
    std::uint32_t remainder = remainder_q << 2 | bits;
    const std::uint32_t trial = static_cast<std::uint32_t>(found_q) << 2 | 1;
    const bool fits = remainder >= trial;
    if (fits) remainder -= trial;
    remainder_q = remainder;
    found_q = found_q << 1 | fits;
  }
};

}  // namespace racebeam
