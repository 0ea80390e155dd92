// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_signal_bench.h"

#include "tb/bench/sphere_bench.h"

namespace racebeam {

SphereSignalBench::SphereSignalBench(const Setting& setting, const BenchWishes& wishes)
    : WiredBench(setting, {true, wishes.crc}),
      program_(sphere_program_of(setting.scene)),
      knobs_(sphere_knobs(setting.k).resolved()),
      wishes_(wishes),
      pictures_(setting.frames) {}

void SphereSignalBench::seek(int picture) {
  if (picture != next_) WiredBench::seek(picture);
  next_ = picture;
}

ChipBench::Frame SphereSignalBench::render() {
  if (next_ == pictures_) seek(0);
  const std::uint32_t pins_crc = WiredBench::render().picture.pins_crc;
  const bool narrow = program_.inputs_before(next_).narrow_q;
  const sphere_counters& n = hands().counters();
  Frame frame{next_,
              sphere_picture(next_, words(), narrow, knobs_, wishes_),
              counted(n),
              {},
              {n.clocks, n.frames}};
  frame.picture.pins_crc = pins_crc;
  ++next_;
  return frame;
}

}  // namespace racebeam
