// VoxelSource: the voxel tracer and its host as a source of pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tb/host/voxel_player.h"
#include "tb/view/sources.h"
#include "tb/view/store_source.h"

namespace racebeam {

class VoxelSource : public StoreSource {
 public:
  /// Stands before picture 0 of `pictures`. The program outlives it.
  VoxelSource(const VoxelProgram& program, const voxel_knobs& k, int pictures);

  bool plain() const override { return true; }

 private:
  void restart() override { player_.seek(0); }
  std::vector<std::uint64_t> draw() override;
  void skip() override { skipped_ = true; }
  int picture_rows() const override { return knobs_.picture_height; }
  std::uint64_t picture_clocks() const override;
  frame_counts counts() const override { return counted(player_.machine().counters()); }
  const std::vector<counter_info>& counter_infos() const override;

  const voxel_knobs knobs_;
  VoxelPlayer player_;
  bool skipped_ = false;
};

/// The row of sources().
SourceKind voxel_sources();

}  // namespace racebeam
