// FramesWalk: sequencer and timeline through all frames of the demo, and what follows the last.
// FrameWalk: vga_timing through a whole frame.
//
// Random traffic is reset, or its episode ends, long before either.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/constants.h"
#include "sc/base/knob_values.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class FramesWalk {
 public:
  static constexpr int FrameClocks = 4;
  static constexpr std::uint64_t Clocks = (DemoFrames + 200) * FrameClocks;

  /// For a unit that counts frames on `bench`; the same seed makes the same traffic.
  FramesWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  UnitBench& bench_;
  const LegalInputs legal_;
  std::mt19937 random_;
  int clock_ = 0;
};

class FrameWalk {
 public:
  /// A frame of the slowest pixels that the chip has, and the next one until its picture has begun;
  /// there a reset ends it.
  static constexpr std::uint64_t Clocks = 900'000, SecondReset = 895'000;

  /// For vga_timing on `bench`; the same seed makes the same traffic.
  FrameWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  UnitBench& bench_;
  std::mt19937 random_;
  std::uint64_t clock_ = 0;
  int left_ = 0;  // clocks with this speed
};

}  // namespace racebeam
