// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_bench.h"

#include "tb/bench/block_signal_bench.h"
#include "tb/bench/block_tlm_bench.h"
#include "tb/bench/store_picture.h"
#include "tb/bench/store_pins.h"

namespace racebeam {

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
                         rgb888_picture(picture, words, k.store()),
                         counted(counters),
                         {},
                         {counters.clocks, counters.frames}};
  bar.add(counters);
  if (k.load_bar) bar.draw(frame.picture);
  if (wishes.crc) frame.picture.image_crc = image_crc(frame.picture);
  return frame;
}

}  // namespace racebeam
