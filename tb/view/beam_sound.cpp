// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/beam_sound.h"

#include <cmath>
#include <numeric>

namespace racebeam {

namespace {

constexpr int HalfLine = LinePixels;  // clocks, two a pixel
constexpr double CapacitorHz = 5;
constexpr double Pi = 3.14159265358979323846;

}  // namespace

std::vector<float> BeamSound::play(int frame) {
  static const double pull = 1 - std::exp(-2 * Pi * CapacitorHz / SampleRate);
  std::vector<float> samples;
  samples.reserve(FrameSamples);
  for (int y = FirstLine; y <= LastLine; ++y) {
    bool level = core_.comb().pwm;
    run_sound_line(core_, raster_, 0, y, frame, changes_);
    auto change = changes_.begin();
    for (int half = 0; half < 2; ++half) {
      const int end = (half + 1) * HalfLine;
      int high = 0;
      for (int clock = end - HalfLine; clock < end;) {
        const bool changes = change != changes_.end() && change->clock < end;
        const int until = changes ? change->clock : end;
        high += level ? until - clock : 0;
        clock = until;
        if (changes) level = change++->level;
      }
      samples.push_back(static_cast<float>(2.0 * high / HalfLine - 1));
    }
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
