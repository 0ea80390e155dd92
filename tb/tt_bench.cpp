// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt_bench.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

constexpr int ResetClocks = 10;
constexpr std::uint64_t SearchStep = 105'000;  // clocks

}  // namespace

TtBench::TtBench(TtChip& chip, const TtProject& project, bool crc, bool sound, int first)
    : chip_(chip),
      found_(find(static_cast<double>(project.clock_hz))),
      vga_(
          found_.raster, [this](const VgaFrame& frame) { picture_ = frame; }, {crc, crc}, &faults_),
      sound_(sound ? new SoundMonitor(std::llround(found_.clock_hz)) : nullptr),
      sound_begin_(found_.first + std::uint64_t(first) * found_.raster.frame_clocks()),
      next_(found_.first) {
  // The pins in the first clock of frame 0.
  const auto after = std::upper_bound(
      changes_.begin(), changes_.end(), next_,
      [](std::uint64_t clock, const PinChange& change) { return clock < change.clock; });
  changes_.erase(changes_.begin(), after - 1);
  changes_.front().clock = next_;
}

FoundFrames TtBench::find(double clock_hz) {
  chip_.reset(ResetClocks);
  for (;;) {
    chip_.run(SearchStep, changes_);
    if (const auto found = find_frames(changes_, chip_.clock(), clock_hz)) return *found;
  }
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
  if (chip_.clock() < next_) chip_.run(next_ - chip_.clock(), changes_);
  std::size_t seen = 0;
  for (; seen < changes_.size() && changes_[seen].clock < next_; ++seen) feed(changes_[seen]);
  changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(seen));
  vga_.advance(next_ - found_.first);
  if (sound_ && next_ > sound_begin_) sound_->advance(next_ - sound_begin_);
  Frame frame{picture_, counter_.take(next_)};
  for (const std::uint8_t colour : frame.picture.colours) frame.stats.colours.set(colour);
  return frame;
}

}  // namespace racebeam
