// HostWalk: sphere_host_link until it shows the built-in scene, and a CPU that comes late; and
// before, one that is there when there is a reset.
//
// Random traffic sends words all the time, and is reset long before the link gives up waiting.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/knob_values.h"
#include "sc/sphere/codes.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class HostWalk {
 public:
  /// A CPU answers, and there is a reset.
  static constexpr std::uint64_t FirstReset = 64;
  /// The tracer waits in 7 of 8 clocks; then there are a few hundred pictures.
  static constexpr std::uint64_t Silence = FirstReset + HostPatience + HostPatience / 7 + 10'000;
  static constexpr std::uint64_t Clocks = Silence + 4'000;

  /// For sphere_host_link on `bench`; the same seed makes the same traffic.
  HostWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  bool one_in(int count) { return random_() % static_cast<unsigned>(count) == 0; }

  UnitBench& bench_;
  std::mt19937 random_;
  std::uint64_t clock_ = 0;
  int listened_ = 0;  // clocks, and a pause
};

}  // namespace racebeam
