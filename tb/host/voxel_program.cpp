// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_program.h"

#include "sc/voxel/voxel_world.h"

namespace racebeam {

namespace {

/// Greens, from dark to light.
voxel_palette greens() {
  voxel_palette palette{};
  for (std::size_t n = 0; n < palette.size(); ++n) {
    const int light = static_cast<int>(n) % VoxelPaletteHeights;
    palette[n] = (40 + 8 * light) << 16 | (90 + 10 * light) << 8 | (30 + 6 * light);
  }
  return palette;
}

}  // namespace

const VoxelProgram& builtin_voxel_program() {
  static const VoxelProgram program = [] {
    VoxelProgram tiny;
    for (int y = 0; y < tiny.size[1]; ++y)
      for (int x = 0; x < tiny.size[0]; ++x) {
        const int low = 4 + ((7 * x + 13 * y) & 7) + (x == 20 && y == 30 ? 16 : 0);
        tiny.columns.push_back(packed({low, low, low, 0, 0}));
      }
    tiny.palette = greens();
    tiny.views = {{{32 * 256 + 128, 2 * 256 + 64, 40 * 256},
                   {-6710880, 10066330, -838866},
                   {209715, 0, 0},
                   {0, 0, -209715}}};
    return tiny;
  }();
  return program;
}

const VoxelProgram& voxel_program_of(const scene_tables* scene) {
  return scene ? *static_cast<const VoxelProgram*>(scene) : builtin_voxel_program();
}

}  // namespace racebeam
