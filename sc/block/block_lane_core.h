// Behaviour of block_lane (block_lane.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/block/numbers.h"

namespace racebeam {

struct block_lane_core {
  int b_q = 0;

  struct inputs {
    bool secondary;
    vec3 a, dir;
    int k;
  };
  struct outputs {
    int b;
    std::int64_t d;  // 33 bits
  };

  outputs comb(const inputs& in) const {
    const int b = in.secondary ? b_q : idot(in.a, in.dir);
    const std::int64_t d = std::int64_t{imul(b, b)} + in.k - (in.secondary ? inorm2(in.a) : 0);
    return {b, signed_bits(static_cast<std::uint64_t>(d), BlockDistanceBits)};
  }
  void clock(const inputs& in) {
    if (!in.secondary) b_q = idot(in.a, in.dir);
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("b_q", BlockBits, [this] { return b_q; });
  }
};

}  // namespace racebeam
