// ShaderWalk: sphere_shader through pixels as sphere_tracer asks for them.
//
// Random operations seldom add a bright hit to a ray that has been weakened by a mirror, which is
// where the highest bits of a colour and of a sum count.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/knob_values.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class ShaderWalk {
 public:
  static constexpr std::uint64_t Clocks = 60'000;

  /// For sphere_shader on `bench`; the same seed makes the same traffic.
  ShaderWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  bool one_in(int count) { return random_() % static_cast<unsigned>(count) == 0; }
  std::uint64_t high_or_any(int bits);
  void begin_pixel();
  void hit();

  UnitBench& bench_;
  std::mt19937 random_;
  bool begun_ = false;
  int sub_ = 0, subs_ = 0;  // rays of the pixel: the current one, all
  int hits_ = 0;            // that are still to come on the ray
  bool adds_ = false;       // the hit was shaded
};

}  // namespace racebeam
