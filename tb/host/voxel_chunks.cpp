// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_chunks.h"

namespace racebeam {

namespace {

std::size_t columns_of(const voxel_rectangle& r) {
  return static_cast<std::size_t>(r.x_high - r.x_low) *
         static_cast<std::size_t>(r.y_high - r.y_low);
}

}  // namespace

VoxelChunks::VoxelChunks(const voxel_knobs& k)
    : levels_(k), chunk_(static_cast<std::size_t>(k.build_chunk)) {}

void VoxelChunks::add(const voxel_rectangle& columns) {
  expect_buildable(columns, levels_.size());
  split(voxel_aligned(columns, levels_, 0));
}

void VoxelChunks::split(const voxel_rectangle& voxels) {
  const auto& [x_low, y_low, x_high, y_high] = voxels;
  if (x_low == x_high || y_low == y_high) return;
  const int x_side = levels_.side(0, 0), y_side = levels_.side(0, 1);
  const voxel_rectangle columns{x_low * x_side, y_low * y_side, x_high * x_side, y_high * y_side};
  if (columns_of(columns) <= chunk_ || (x_high - x_low == 1 && y_high - y_low == 1)) {
    queue_.push_back(columns);
    return;
  }
  const int x = (x_low + x_high) / 2, y = (y_low + y_high) / 2;
  split({x_low, y_low, x, y});
  split({x, y_low, x_high, y});
  split({x_low, y, x, y_high});
  split({x, y, x_high, y_high});
}

std::vector<voxel_rectangle> VoxelChunks::frame() {
  std::vector<voxel_rectangle> taken;
  std::size_t columns = 0;
  while (!queue_.empty() && taken.size() < MostAFrame) {
    columns += columns_of(queue_.front());
    if (columns > chunk_ && !taken.empty()) break;
    taken.push_back(queue_.front());
    queue_.pop_front();
  }
  return taken;
}

}  // namespace racebeam
