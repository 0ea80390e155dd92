// The `signal` level of the voxel tracer on the bench: a WiredBench with its host, whose pictures
// are those of the frame store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/bench/voxel_bench.h"
#include "tb/bench/voxel_hands.h"

namespace racebeam {

class VoxelSignalBench final : public WiredBench {
 public:
  /// The scene outlives it. Throws RtlError.
  VoxelSignalBench(const Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override;
  /// Throws as WiredBench's.
  Frame render() override;

 private:
  const VoxelHands& hands() const { return static_cast<const VoxelHands&>(*around()); }

  const voxel_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  int next_ = 0;
};

}  // namespace racebeam
