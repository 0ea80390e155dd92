// TuneWalk: pwm_sound through its whole tune.
//
// What sounds is a function of the frame, and random traffic sees few of the 1,600 steps. Here each
// step of the tune plays for one sample: its first, its last, or any other. Then other samples of
// all frames are heard, each one as soon as the pulse before has ended, with other clocks for the
// high half of the number of samples, so that all of it moves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/knob_values.h"
#include "sc/beam/tune.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class TuneWalk {
 public:
  static constexpr int SampleClocks = 800;
  static constexpr int Steps = tune::Measures * tune::MeasureSteps;
  /// The last sample is heard while the next one is made.
  static constexpr std::uint64_t TuneClocks = static_cast<std::uint64_t>(Steps + 1) * SampleClocks;
  static constexpr int MomentClocks = 512, Moments = 3000;
  static constexpr std::uint64_t Clocks =
      TuneClocks + static_cast<std::uint64_t>(Moments) * MomentClocks;

  /// For pwm_sound on `bench`; the same seed makes the same traffic.
  TuneWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  void next_step(int step);
  void next_moment(int moment);
  int moment_x2(int clock) const;
  void drive_x2(int x2);
  void drive_line(int line);  // of the frame
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  UnitBench& bench_;
  std::mt19937 random_;
  int clock_ = 0;
  int first_x2_ = 0;  // of the moment: where its first voice begins
  int skipped_ = 0;   // clocks in which its carry is added to the high half
};

}  // namespace racebeam
