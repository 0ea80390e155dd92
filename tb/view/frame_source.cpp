// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_source.h"

#include <stdexcept>

namespace racebeam {

void FrameSource::fly(int, const Pose&) {
  throw std::logic_error(std::string("the level ") + level() + " keeps to the camera's path");
}

}  // namespace racebeam
