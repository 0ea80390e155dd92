// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_player.h"

namespace racebeam {

VoxelPlayer::VoxelPlayer(const VoxelProgram& program, const voxel_knobs& k)
    : machine_(k), show_(program, k) {}

void VoxelPlayer::seek(int picture) {
  if (picture == next()) return;
  show_.go_to(picture);
  if (picture > 0) machine_.deposit(show_.columns());
}

void VoxelPlayer::perform(const VoxelDeed& deed) {
  const voxel_rectangle& r = deed.rectangle;
  switch (deed.kind) {
    case VoxelDeed::Colours:
      for (int n = 0; n < VoxelPaletteEntries; ++n)
        machine_.write_colour(n, show_.palette()[static_cast<std::size_t>(n)]);
      break;
    case VoxelDeed::Columns:
      for (int y = r.y_low; y < r.y_high; ++y)
        for (int x = r.x_low; x < r.x_high; ++x)
          machine_.write_column(show_.address(x, y), show_.columns()[show_.address(x, y)]);
      break;
    case VoxelDeed::Build: machine_.build(r); break;
    case VoxelDeed::Frame: machine_.go_to_frame(); break;
  }
}

void VoxelPlayer::draw() {
  machine_.await_frame();
  for (const VoxelDeed& deed : show_.next()) perform(deed);
  machine_.draw(show_.view());
}

}  // namespace racebeam
