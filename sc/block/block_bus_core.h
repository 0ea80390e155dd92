// Behaviour of block_bus (block_bus.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/block/knobs.h"

namespace racebeam {

struct block_bus_core {
  std::uint64_t later_q = 0;  // the cores after the one that was served last

  /// The bit of the core that is up; 0: nobody asks.
  std::uint64_t up(std::uint64_t asks, const block_knobs& k) const {
    const std::uint64_t there = raw_bits(asks, k.cores);
    const std::uint64_t first = there & later_q ? there & later_q : there;
    return first & (~first + 1);
  }
  static int number(std::uint64_t bit) { return bit ? __builtin_ctzll(bit) : 0; }
  void clock(bool rst_n, std::uint64_t asks, bool ready, const block_knobs& k) {
    if (!rst_n) {
      later_q = 0;
    } else if (const std::uint64_t served = up(asks, k); served && ready) {
      later_q = raw_bits(~(served | (served - 1)), k.cores);
    }
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit, const block_knobs& k) const {
    visit("later_q", k.cores, [this] { return later_q; });
  }
};

}  // namespace racebeam
