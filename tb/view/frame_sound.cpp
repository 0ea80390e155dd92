// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_sound.h"

#include <cmath>
#include <numeric>

namespace racebeam {

namespace {

constexpr int HalfLine = LinePixels;  // clocks, two a pixel
constexpr double CapacitorHz = 5;
constexpr double Pi = 3.14159265358979323846;

}  // namespace

std::vector<float> FrameSound::play(int frame) {
  static const double pull = 1 - std::exp(-2 * Pi * CapacitorHz / Rate);
  std::vector<float> samples;
  samples.reserve(FrameSamples);
  for (int y = FirstLine; y <= LastLine; ++y)
    for (int half = 0; half < 2; ++half) {
      int high = 0;
      for (int i = 0; i < HalfLine; ++i) {
        high += core_.comb().pwm;
        core_.clock({true, 0, 2 * FirstPosition + half * HalfLine + i, y, frame});
      }
      const double level = 2.0 * high / HalfLine - 1;
      samples.push_back(static_cast<float>(level));
    }
  // A coupling capacitor, charged beforehand.
  if (!started_) mean_ = std::accumulate(samples.begin(), samples.end(), 0.0) / FrameSamples;
  started_ = true;
  for (float& sample : samples) {
    mean_ += pull * (sample - mean_);
    sample = static_cast<float>(sample - mean_);
  }
  return samples;
}

}  // namespace racebeam
