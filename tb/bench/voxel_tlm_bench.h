// The `tlm` level of the voxel tracer on the bench: its units in one loop, and a host that is plain
// code.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/bench/voxel_bench.h"
#include "tb/host/voxel_player.h"

namespace racebeam {

class VoxelTlmBench final : public ChipBench {
 public:
  /// The scene outlives it.
  VoxelTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override { player_.seek(picture); }
  Frame render() override;
  std::uint64_t clocks() const override {
    return static_cast<std::uint64_t>(player_.machine().store().clock());
  }
  const SoundMonitor* sound() const override { return nullptr; }

  /// As voxel_machine has it.
  void note(std::vector<std::int64_t>* begins) { player_.machine().note(begins); }

 private:
  const voxel_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  VoxelPlayer player_;
};

/// BenchKind::pixels.
PixelClocks voxel_pixels(const WiredBench::Setting& setting, int picture);

}  // namespace racebeam
