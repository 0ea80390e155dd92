// sound_line: the PWM pin over a scan line, from event to event.
//
// The sound depends on nothing but time, so it can be had without the rest of the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/pwm_sound.h"
#include "sc/beam/tlm/line_raster.h"

namespace racebeam {

/// The PWM pin has this level from a clock of the line on.
struct pwm_change {
  int clock;
  bool level;
};

/// Runs `sound` over line `y` of a frame, whose clocks are those of `raster`, made for the same
/// `speed` pins. `changes` gets the changes of the pin; the last may be one clock after the line.
inline void run_sound_line(pwm_sound_core& sound, const line_raster& raster, int speed, int y,
                           int frame, std::vector<pwm_change>& changes) {
  changes.clear();
  bool level = sound.comb().pwm;
  const auto change = [&](int clock) {
    if (sound.comb().pwm == level) return;
    level = !level;
    changes.push_back({clock, level});
  };
  int now = 0;
  const auto hold_until = [&](int clock) {
    const int rise = now + sound.rises_in();
    sound.hold(clock - now);
    change(rise);
    now = clock;
  };
  for (const int clock : raster.sound_clocks) {
    hold_until(clock);
    sound.clock({true, speed, raster.x2[clock], y, frame});
    change(clock + 1);
    now = clock + 1;
  }
  hold_until(raster.size());
}

}  // namespace racebeam
