// SubdividerWalk: subdivider with a full stack, over its end, and empty again.
//
// To push an interval it has to bisect one for some ten clocks, with answers that fit each other,
// and for five the random ones never fit. Here they do: the far end of an interval sees something
// else than its beginning, and the middle what the beginning sees.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/knob_values.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class SubdividerWalk {
 public:
  static constexpr std::uint64_t Clocks = 300'000;

  /// For subdivider on `bench`; the same seed makes the same traffic.
  SubdividerWalk(UnitBench& bench, const knob_values&, unsigned seed)
      : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  bool one_in(int count) { return below(count) == 0; }
  void begin_line();
  void answer();

  UnitBench& bench_;
  std::mt19937 random_;
  bool begun_ = false;
  bool pops_ = false;  // walls everywhere, so that the stack gets empty
  int left_ = 0;       // clocks until it changes
};

}  // namespace racebeam
