// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_tlm_bench.h"

#include <utility>

#include "tb/bench/store_pins.h"

namespace racebeam {

BlockTlmBench::BlockTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes)
    : program_(block_program_of(setting.scene)),
      knobs_(setting.k),
      wishes_(wishes),
      pictures_(setting.frames),
      machine_(knobs_),
      motion_(program_, knobs_),
      bar_(knobs_) {}

void BlockTlmBench::seek(int picture) {
  if (picture == next_) return;
  motion_ = BlockMotion(program_, knobs_);
  bar_.forget();
  for (next_ = 0; next_ < picture; ++next_)
    if (next_ > 0) motion_.picture();
}

ChipBench::Frame BlockTlmBench::render() {
  if (next_ == pictures_) seek(0);
  machine_.await_frame();
  if (next_ > 0) motion_.picture();
  machine_.draw(motion_.tables());
  const std::vector<std::uint64_t> drawn = words();
  Frame frame = block_frame(next_, drawn, machine_.counters(), knobs_, bar_, wishes_);
  if (wishes_.crc)
    frame.picture.pins_crc = store_pins_crc(drawn, knobs_.store(), block_knobs::clocks_per_pixel);
  ++next_;
  return frame;
}

PixelClocks block_pixels(const WiredBench::Setting& setting, int picture) {
  BlockTlmBench bench(setting, {});
  bench.seek(picture);
  block_renderer::notes notes;
  bench.note(&notes);
  const ChipBench::Frame frame = bench.render();
  PixelClocks pixels{frame.picture.width, frame.picture.height, std::move(notes.begins)};
  pixels.begins.push_back(static_cast<std::int64_t>(bench.clocks()));
  return pixels;
}

}  // namespace racebeam
