// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_bench.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

TtBench::TtBench(TtRun& run, bool crc, bool sound, int first)
    : run_(run),
      found_(run.found()),
      vga_(
          found_.raster, [this](const VgaFrame& frame) { picture_ = frame; }, {crc, crc}, &faults_),
      sound_(sound ? new SoundMonitor(std::llround(found_.clock_hz)) : nullptr),
      sound_begin_(found_.first + std::uint64_t(first) * found_.raster.frame_clocks()),
      next_(found_.first) {
  // The pins in the first clock of frame 0 are what they changed to last.
  run_.run(next_ + 1, changes_);
  changes_.erase(changes_.begin(), changes_.end() - 1);
  changes_.front().clock = next_;
}

void TtBench::feed(const PinChange& pins) {
  vga_.change(pins.clock - found_.first, pins.uo);
  counter_.change(pins);
  const bool driven = (pins.oe >> SoundPin) & 1;
  has_sound_pin_ |= driven;
  if (!sound_ || !driven) return;
  const std::uint64_t clock = std::max(pins.clock, sound_begin_) - sound_begin_;
  sound_->change(clock, (pins.uio >> SoundPin) & 1);
}

TtBench::Frame TtBench::render() {
  next_ += found_.raster.frame_clocks();
  run_.run(next_, changes_);
  for (const PinChange& change : changes_) feed(change);
  changes_.clear();
  vga_.advance(next_ - found_.first);
  if (sound_ && next_ > sound_begin_) sound_->advance(next_ - sound_begin_);
  Frame frame{picture_, counter_.take(next_)};
  for (const std::uint8_t colour : frame.picture.colours) frame.stats.colours.set(colour);
  return frame;
}

}  // namespace racebeam
