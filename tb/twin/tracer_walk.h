// TracerWalk: sphere_tracer to the end of two pictures, and with operands that meet.
//
// Random traffic draws no picture to its end: that takes hundreds of thousands of clocks without a
// reset. Nor are two of its operands of 24 bits ever equal, which is where a comparison tells
// whether it is `<` or `<=`. Here the tracer first goes through pictures of black pixels, six
// clocks each; then all numbers come from one that is drawn anew now and then, and what it waits
// for comes soon.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "sc/base/knob_values.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class TracerWalk {
 public:
  static constexpr int Pictures = 2;
  static constexpr std::uint64_t Clocks = 1'725'000;  ///< all but 340,000 for the pictures

  /// For sphere_tracer on `bench`; the same seed makes the same traffic.
  TracerWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  void begin_picture();
  void go_through_pictures();
  void begin_episode();
  void begin_mirrors();
  void begin_ties();
  void drive_limits();
  void drive_ties();
  std::uint64_t number(int bits);
  bool one_in(int count) { return random_() % static_cast<unsigned>(count) == 0; }

  UnitBench& bench_;
  const int min_weight_;
  std::mt19937 random_;
  std::vector<UnitBench::Pin*> flags_, modes_, numbers_;
  bool begun_ = false, narrow_ = false;
  enum class Kind { Any, Mirrors, Ties } kind_ = Kind::Any;  // of the episode
  int drawn_ = 0;                                            // pictures
  int left_ = 0;                                             // clocks of the episode
  bool passes_ = false;                                      // rays pass spheres
  int reach_ = 0;            // planes have limits up to this many units; 0: as all numbers
  std::uint64_t value_ = 0;  // of its numbers
};

}  // namespace racebeam
