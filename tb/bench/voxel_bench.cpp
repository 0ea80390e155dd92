// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/voxel_bench.h"

#include "tb/bench/store_picture.h"
#include "tb/bench/store_pins.h"
#include "tb/bench/voxel_signal_bench.h"
#include "tb/bench/voxel_tlm_bench.h"

namespace racebeam {

std::unique_ptr<ChipBench> make_voxel_bench(const std::string& level,
                                            const WiredBench::Setting& setting,
                                            const BenchWishes& wishes) {
  if (level != setting.built.levels.front())
    return std::make_unique<VoxelSignalBench>(setting, wishes);
  return std::make_unique<VoxelTlmBench>(setting, wishes);
}

ChipBench::Frame voxel_frame(int picture, const std::vector<std::uint64_t>& words,
                             const voxel_counters& counters, const voxel_knobs& k,
                             const BenchWishes& wishes) {
  ChipBench::Frame frame{picture,
                         rgb888_picture(picture, words, k.store()),
                         counted(counters),
                         {},
                         {counters.clocks, counters.frames}};
  if (wishes.crc) frame.picture.image_crc = image_crc(frame.picture);
  return frame;
}

}  // namespace racebeam
