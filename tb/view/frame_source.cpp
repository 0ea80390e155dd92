// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_source.h"

#include <stdexcept>

namespace racebeam {

double FrameSource::clock_hz() const {
  constexpr double FramesPerSecond = 60;
  return FramesPerSecond * watch().raster().frame_clocks();
}

const std::vector<IntervalEvent>& FrameSource::intervals() const {
  static const std::vector<IntervalEvent> none;
  return none;
}

void FrameSource::fly(int, const Pose&) {
  throw std::logic_error(std::string("the level ") + level() + " keeps to the camera's path");
}

}  // namespace racebeam
