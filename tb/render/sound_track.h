// SoundTrack: the sound of frames in a row, without the rest of the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/beam/tlm/sound_line.h"
#include "tb/monitor/sound_monitor.h"

namespace racebeam {

class SoundTrack {
 public:
  explicit SoundTrack(const knobs& k);

  /// A frame more, as it sounds after those before it; the first begins with the registers as they
  /// are after reset.
  void play(int frame);

  const SoundMonitor& sound() const { return sound_; }

 private:
  const int speed_;
  const line_raster raster_;
  pwm_sound_core core_;
  std::vector<pwm_change> changes_;
  SoundMonitor sound_;
  std::uint64_t begin_ = 0;  // clock 0 of the next line
};

}  // namespace racebeam
