// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/sound_track.h"

#include "sc/base/constants.h"

namespace racebeam {

SoundTrack::SoundTrack(const knobs& k) : speed_(k.speed), raster_(k) {
  const bool level = core_.comb().pwm;
  core_.clock({false, speed_, raster_.x2[0], FirstLine, 0});  // as the chip, a clock in reset
  sound_.change(0, level);
}

void SoundTrack::play(int frame) {
  for (int y = FirstLine; y <= LastLine; ++y) {
    run_sound_line(core_, raster_, speed_, y, frame, changes_);
    for (const pwm_change& change : changes_)
      sound_.change(begin_ + static_cast<std::uint64_t>(change.clock), change.level);
    begin_ += static_cast<std::uint64_t>(raster_.size());
  }
  sound_.advance(begin_);
}

}  // namespace racebeam
