// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_signal_bench.h"

namespace racebeam {

BlockSignalBench::BlockSignalBench(const Setting& setting, const BenchWishes& wishes)
    : WiredBench(setting, {true, wishes.crc}),
      knobs_(setting.k),
      wishes_(wishes),
      pictures_(setting.frames),
      bar_(knobs_) {}

void BlockSignalBench::seek(int picture) {
  if (picture == next_) return;
  WiredBench::seek(picture);
  bar_.forget();
  next_ = picture;
}

ChipBench::Frame BlockSignalBench::render() {
  if (next_ == pictures_) seek(0);
  const std::uint32_t pins_crc = WiredBench::render().picture.pins_crc;
  Frame frame = block_frame(next_, words(), hands().counters(), knobs_, bar_, wishes_);
  frame.picture.pins_crc = pins_crc;
  ++next_;
  return frame;
}

}  // namespace racebeam
