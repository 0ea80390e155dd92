// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/tt_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/view/frame_source.h"

namespace racebeam {

TtSource::TtSource(TtRun& run, int sound_pin)
    : run_(run),
      sound_pin_(sound_pin),
      watch_(run.found().raster),
      sound_(run.clock_hz(), FrameSource::SoundRate) {
  seek(0);
}

std::uint64_t TtSource::begin_of(int frame) const {
  const FoundFrames& found = run_.found();
  return found.first + static_cast<std::uint64_t>(frame) * found.raster.frame_clocks();
}

void TtSource::seek(int frame) {
  frame_ = frame;
  const std::uint64_t begin = begin_of(frame);
  if (run_.clock() > begin) run_.restart();
  // What is near is done at once.
  const auto near = static_cast<std::uint64_t>(watch_.raster().frame_clocks());
  if (begin - run_.clock() <= near) run_.run(begin, changes_);
  if (!changes_.empty()) now_ = changes_.back();
  changes_.clear();
  watch_.restart();
}

// The pins of these clocks as the screen sees them and the loudspeaker hears them.
void TtSource::show(std::uint64_t from, std::uint64_t until) {
  auto next = changes_.begin();
  while (from < until) {
    for (; next != changes_.end() && next->clock <= from; ++next) now_ = *next;
    const std::uint64_t end = next == changes_.end() ? until : next->clock;
    const bool driven = now_.oe >> sound_pin_ & 1;
    sound_.add(end - from, driven && (now_.uio >> sound_pin_ & 1));
    heard_ |= driven;
    for (; from < end; ++from) watch_.clock(now_.uo, frame_);
  }
}

int TtSource::advance(int clocks) {
  if (watch_.whole()) ++frame_;
  const std::uint64_t begin = begin_of(frame_);
  const std::uint64_t from = run_.clock();
  // What is before the frame is simulated and not shown.
  const std::uint64_t limit = from < begin ? begin : begin_of(frame_ + 1);
  const std::uint64_t until = std::min<std::uint64_t>(from + clocks, limit);
  changes_.clear();
  run_.run(until, changes_);
  if (from < begin) {
    if (!changes_.empty()) now_ = changes_.back();
  } else {
    show(from, until);
  }
  return static_cast<int>(until - from);
}

void TtSource::press(TilePins pins) {
  if (run_.clock() >= begin_of(frame_)) run_.press(pins);
}

FrameSource::Rows TtSource::rows() const {
  const TilePins in = run_.pins();
  const auto bits = [](int value) { return fmt::format("{:08b}", value); };
  return {{"ui_in", bits(in.ui)},
          {"uio_in", bits(in.uio)},
          {"uo_out", bits(now_.uo)},
          {"uio_out", bits(now_.uio)},
          {"uio_oe", bits(now_.oe)},
          {"", ""},
          {"input changes", std::to_string(run_.inputs().changes().size())},
          {"sound", fmt::format(heard_ ? "uio_out[{}]" : "uio_oe[{}] is 0", sound_pin_)}};
}

}  // namespace racebeam
