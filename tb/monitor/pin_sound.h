// PinSound: a pin of a running chip as samples that can be played at once.
//
// A sample is the mean level of its time; SoundMonitor, which filters properly, knows the sound
// only when it is over.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

class PinSound {
 public:
  /// `clock_hz` clocks a second, at least `rate`; `rate` samples a second.
  PinSound(double clock_hz, int rate);

  /// The pin has this level for so many clocks more.
  void add(std::uint64_t clocks, bool level);
  /// The samples that are whole since the last call, -1..1 around the mean level so far.
  std::vector<float> take();

 private:
  const double clocks_per_sample_, pull_;
  std::vector<float> samples_;
  double left_;      // clocks of the sample that are missing
  double high_ = 0;  // clocks of the sample in which the pin was 1
  double mean_ = 0;
  bool started_ = false;
};

}  // namespace racebeam
