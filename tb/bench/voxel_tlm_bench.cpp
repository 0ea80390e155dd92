// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/voxel_tlm_bench.h"

#include <utility>

#include "tb/bench/store_pins.h"

namespace racebeam {

VoxelTlmBench::VoxelTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes)
    : knobs_(setting.k),
      wishes_(wishes),
      pictures_(setting.frames),
      player_(voxel_program_of(setting.scene), knobs_) {}

ChipBench::Frame VoxelTlmBench::render() {
  if (player_.next() == pictures_) seek(0);
  const int picture = player_.next();
  player_.draw();
  const std::vector<std::uint64_t> drawn = player_.machine().picture();
  Frame frame = voxel_frame(picture, drawn, player_.machine().counters(), knobs_, wishes_);
  if (wishes_.crc)
    frame.picture.pins_crc = store_pins_crc(drawn, knobs_.store(), voxel_knobs::clocks_per_pixel);
  return frame;
}

PixelClocks voxel_pixels(const WiredBench::Setting& setting, int picture) {
  VoxelTlmBench bench(setting, {});
  bench.seek(picture);
  std::vector<std::int64_t> begins;
  bench.note(&begins);
  const ChipBench::Frame frame = bench.render();
  PixelClocks pixels{frame.picture.width, frame.picture.height, std::move(begins)};
  pixels.begins.push_back(static_cast<std::int64_t>(bench.clocks()));
  return pixels;
}

}  // namespace racebeam
