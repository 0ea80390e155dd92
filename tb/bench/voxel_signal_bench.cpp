// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/voxel_signal_bench.h"

namespace racebeam {

VoxelSignalBench::VoxelSignalBench(const Setting& setting, const BenchWishes& wishes)
    : WiredBench(setting, {true, wishes.crc}),
      knobs_(setting.k),
      wishes_(wishes),
      pictures_(setting.frames) {}

void VoxelSignalBench::seek(int picture) {
  if (picture == next_) return;
  WiredBench::seek(picture);
  next_ = picture;
}

ChipBench::Frame VoxelSignalBench::render() {
  if (next_ == pictures_) seek(0);
  const std::uint32_t pins_crc = WiredBench::render().picture.pins_crc;
  Frame frame = voxel_frame(next_, hands().memory(), hands().counters(), knobs_, wishes_);
  frame.picture.pins_crc = pins_crc;
  ++next_;
  return frame;
}

}  // namespace racebeam
