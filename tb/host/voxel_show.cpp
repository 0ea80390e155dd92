// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_show.h"

#include "tb/host/voxel_chunks.h"
#include "tb/host/voxel_craters.h"

namespace racebeam {

VoxelShow::VoxelShow(const VoxelProgram& program, const voxel_knobs& k)
    : program_(&program), knobs_(k), columns_(program.columns) {}

void VoxelShow::go_to(int picture) {
  columns_ = program_->columns;
  for (picture_ = -1; picture_ + 1 < picture;) change(++picture_);
}

std::vector<voxel_rectangle> VoxelShow::change(int picture) {
  std::vector<voxel_rectangle> changed;
  for (const VoxelCrater& crater : program_->craters) {
    if (crater.picture != picture) continue;
    const auto parts = make_crater(crater, knobs_.size(), columns_);
    changed.insert(changed.end(), parts.begin(), parts.end());
  }
  return changed;
}

std::vector<VoxelDeed> VoxelShow::next() {
  std::vector<voxel_rectangle> changed = change(++picture_);
  if (picture_ == 0) changed = {{0, 0, knobs_.size_x, knobs_.size_y}};
  std::vector<VoxelDeed> deeds = {{VoxelDeed::Colours}};
  VoxelChunks chunks(knobs_);
  for (const voxel_rectangle& r : changed) chunks.add(r);
  for (bool first = true; !chunks.empty(); first = false) {
    const std::vector<voxel_rectangle> frame = chunks.frame();
    if (!first) deeds.push_back({VoxelDeed::Frame});
    for (const voxel_rectangle& part : frame) deeds.push_back({VoxelDeed::Columns, part});
    for (const voxel_rectangle& part : frame) deeds.push_back({VoxelDeed::Build, part});
  }
  return deeds;
}

}  // namespace racebeam
