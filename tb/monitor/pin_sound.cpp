// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_sound.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace racebeam {

namespace {

constexpr double CapacitorHz = 5;
constexpr double Pi = 3.14159265358979323846;

}  // namespace

PinSound::PinSound(double clock_hz, int rate)
    : clocks_per_sample_(clock_hz / rate),
      pull_(1 - std::exp(-2 * Pi * CapacitorHz / rate)),
      left_(clocks_per_sample_) {}

void PinSound::add(std::uint64_t clocks, bool level) {
  for (auto rest = static_cast<double>(clocks); rest > 0;) {
    const double part = std::min(rest, left_);
    if (level) high_ += part;
    rest -= part;
    left_ -= part;
    if (left_ > 0) return;
    // A coupling capacitor, charged beforehand.
    const double sample = 2 * high_ / clocks_per_sample_ - 1;
    mean_ = started_ ? mean_ + pull_ * (sample - mean_) : sample;
    started_ = true;
    samples_.push_back(static_cast<float>(sample - mean_));
    left_ = clocks_per_sample_;
    high_ = 0;
  }
}

std::vector<float> PinSound::take() { return std::exchange(samples_, {}); }

}  // namespace racebeam
