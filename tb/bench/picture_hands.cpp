// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/picture_hands.h"

#include "tb/monitor/raster.h"

namespace racebeam {

PictureHands::PictureHands(picture_chip& chip, int clocks_per_pixel)
    : chip_(chip), frame_clocks_(Raster(clocks_per_pixel).frame_clocks()) {}

void PictureHands::seek(int picture) {
  go_to(picture);
  next_ = picture;
  frame_clock_ = 0;
  held_ = false;
  begin_next();
}

void PictureHands::give_up() {
  hold();
  busy_ = begun_ = false;
}

// In the first clock of a frame, which is about to begin or has just begun.
void PictureHands::begin_next() {
  chip_.begin_picture();
  begun_ = true;
  busy_ = false;
  begin(next_);
}

void PictureHands::clock() {
  const bool last = ++frame_clock_ == frame_clocks_;  // clock of the frame, ending now
  if (last) frame_clock_ = 0;
  if (!begun_) {
    if (held_) return;
    if (last && resting_-- == 0) begin_next();
    else if (resting_ == 0 && frame_clock_ == frame_clocks_ - 1) prepare(next_);
    return;
  }
  busy_ = true;
  if (!send() || chip_.storing()) return;
  memory_ = chip_.memory();
  end();
  begun_ = busy_ = false;
  resting_ = rest_;
  ++next_;
  ++pictures_;
}

}  // namespace racebeam
