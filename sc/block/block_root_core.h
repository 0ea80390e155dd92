// Behaviour of block_root (block_root.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/block/knobs.h"
#include "sc/block/numbers.h"

namespace racebeam {

struct block_root_core {
  int step_q = 0;  // clocks that are over; 0: idle, too
  int remainder_q = 0, found_q = 0;

  struct inputs {
    bool rst_n, start;
    int d;
  };

  bool done(const block_knobs& k) const { return step_q == k.root_clocks() - 1; }
  int root(int d, const block_knobs& k) const {
    if (k.root == BlockRootTrick) return isqrt(d);
    if (k.root == BlockRootHeron)
      return d == 0 ? 0 : (isqrt(d) + found_q) >> 1 & low_bits(BlockRootBits);
    return found_q & low_bits(BlockRootBits);
  }
  void clock(const inputs& in, const block_knobs& k) {
    const bool last = done(k);
    if (in.start && !last) {
      if (k.root == BlockRootHeron) divide(in.d);
      else extract(in.d);
    }
    step_q = in.rst_n && in.start && !last ? step_q + 1 : 0;
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("step_q", 4, [this] { return step_q; });
    visit("remainder_q", NumberBits, [this] { return remainder_q; });
    visit("found_q", NumberBits, [this] { return found_q; });
  }

 private:
  static constexpr int NumberBits = 24;

  // Three bits of (d << 20) / isqrt(d).
  void divide(int d) {
    const int divisor = isqrt(d), rest = (d & 15) << BlockFraction;
    if (step_q == 0) {
      remainder_q = d >> 4;
      found_q = 0;
    }
    for (int bit = NumberBits - 1 - 3 * step_q; bit > NumberBits - 4 - 3 * step_q; --bit) {
      remainder_q = (remainder_q << 1 | bit_of(rest, bit)) & low_bits(NumberBits);
      found_q = (found_q << 1 | (remainder_q >= divisor)) & low_bits(NumberBits);
      if (remainder_q >= divisor) remainder_q -= divisor;
    }
  }
  // Two digits of the root of d << 20.
  void extract(int d) {
    if (step_q == 0) remainder_q = found_q = 0;
    const std::int64_t square = std::int64_t{d} << BlockFraction;
    for (int low = 42 - 4 * step_q; low >= 40 - 4 * step_q; low -= 2) {
      remainder_q = (remainder_q << 2 | static_cast<int>(square >> low & 3)) & low_bits(NumberBits);
      const int trial = found_q << 2 | 1;
      found_q = (found_q << 1 | (remainder_q >= trial)) & low_bits(NumberBits);
      if (remainder_q >= trial) remainder_q -= trial;
    }
  }
};

}  // namespace racebeam
