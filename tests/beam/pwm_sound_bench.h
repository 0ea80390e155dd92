// The music as a list of samples, without pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/pwm_sound.h"
#include "sc/beam/tune.h"

namespace racebeam {

constexpr int DemoSamples = DemoFrames * FrameSamples;
constexpr int StepSamples = tune::StepFrames * FrameSamples;

inline int voice_sum(int n) {
  int sum = 0;
  for (int voice = 0; voice < Voices; ++voice)
    sum += voice_value(voice, n & low_bits(PhaseBits), n / FrameSamples, n % FrameSamples);
  return sum;
}

}  // namespace racebeam
