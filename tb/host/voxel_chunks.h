// VoxelChunks: columns that are to be built, as rectangles in a queue, a chunk of them a frame.
//
// A rectangle of more columns than the knob build_chunk is split into four, and so on. They are
// aligned outwards to voxels, of which none is split.
//
// Source: article "Preparation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_build.h"

namespace racebeam {

class VoxelChunks {
 public:
  static constexpr std::size_t MostAFrame = 10;

  /// Throws std::invalid_argument as voxel_levels.
  explicit VoxelChunks(const voxel_knobs& k);

  /// At the end of the queue. Throws std::invalid_argument if it cannot be built.
  void add(const voxel_rectangle& columns);
  bool empty() const { return queue_.empty(); }
  /// Takes what is built in a frame: the oldest, as long as their columns are no more than
  /// build_chunk, MostAFrame at most. The first is taken in any case: it may be a voxel that has
  /// more.
  std::vector<voxel_rectangle> frame();

 private:
  void split(const voxel_rectangle& voxels);

  const voxel_levels levels_;
  const std::size_t chunk_;
  std::deque<voxel_rectangle> queue_;
};

}  // namespace racebeam
