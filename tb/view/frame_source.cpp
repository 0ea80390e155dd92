// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_source.h"

#include <cstdint>
#include <stdexcept>

namespace racebeam {

double FrameSource::clock_hz() const {
  constexpr double FramesPerSecond = 60;
  return FramesPerSecond * watch().raster().frame_clocks();
}

FrameSource::Rows FrameSource::rows() const {
  const frame_stats& s = watch().stats();
  const auto count = [](std::uint64_t value) { return std::to_string(value); };
  return {{"decisions", count(s.decisions())},
          {"bisections", count(s.bisection_steps)},
          {"intervals", count(s.emits)},
          {"rooms entered", count(s.rooms_entered)},
          {"restarts", count(s.restarts)},
          {"given up", count(s.give_ups)},
          {"starved pixels", count(s.starved_pixels)},
          {"FIFO stalls", count(s.fifo_full_stalls)}};
}

void FrameSource::fly(int, const Pose&) {
  throw std::logic_error(std::string("the level ") + level() + " keeps to the camera's path");
}

}  // namespace racebeam
