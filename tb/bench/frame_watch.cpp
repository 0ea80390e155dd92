// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/frame_watch.h"

#include <utility>

namespace racebeam {

void FrameWatch::clock(int uo, int frame) {
  if (whole()) forget();
  ++seen_;
  frame_ = frame;
  screen_.clock(uo);
}

void FrameWatch::restart() {
  forget();
  screen_.home();
}

void FrameWatch::show(std::vector<std::uint8_t> colours, int frame) {
  seen_ = raster_.frame_clocks();
  frame_ = frame;
  screen_.show(std::move(colours));
}

}  // namespace racebeam
