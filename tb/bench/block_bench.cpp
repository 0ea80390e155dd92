// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_bench.h"

#include "sc/store/frame_scanout.h"
#include "tb/bench/block_signal_bench.h"
#include "tb/bench/block_tlm_bench.h"
#include "tb/bench/store_pins.h"

namespace racebeam {

namespace {

VgaFrame block_picture(int picture, const std::vector<std::uint64_t>& words, const block_knobs& k) {
  constexpr int Bits = 8, Low = DacBits - Bits;
  VgaFrame drawn;
  drawn.index = static_cast<std::uint64_t>(picture);
  drawn.width = k.columns();
  drawn.height = k.rows();
  drawn.bits = Bits;
  drawn.colours.reserve(drawn.pixels() * static_cast<std::size_t>(drawn.colour_bytes()));
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto dac = frame_scanout_core::pixel(words, y, x, k.store());
      drawn.push(static_cast<std::uint32_t>((dac.red >> Low << Bits | dac.green >> Low) << Bits |
                                            dac.blue >> Low));
    }
  return drawn;
}

}  // namespace

std::unique_ptr<ChipBench> make_block_bench(const std::string& level,
                                            const WiredBench::Setting& setting,
                                            const BenchWishes& wishes) {
  if (level != setting.built.levels.front())
    return std::make_unique<BlockSignalBench>(setting, wishes);
  return std::make_unique<BlockTlmBench>(setting, wishes);
}

ChipBench::Frame block_frame(int picture, const std::vector<std::uint64_t>& words,
                             const block_counters& counters, const block_knobs& k, LoadBar& bar,
                             const BenchWishes& wishes) {
  ChipBench::Frame frame{picture,
                         block_picture(picture, words, k),
                         counted(counters),
                         {},
                         {counters.clocks, counters.frames}};
  bar.add(counters);
  if (k.load_bar) bar.draw(frame.picture);
  if (wishes.crc) frame.picture.image_crc = image_crc(frame.picture);
  return frame;
}

}  // namespace racebeam
