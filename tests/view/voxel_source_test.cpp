// The voxel tracer as a source of pictures for the viewer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/voxel_source.h"

#include <gtest/gtest.h>

#include "sc/store/frame_scanout.h"
#include "sc/voxel/engine.h"

namespace racebeam {
namespace {

constexpr int Pictures = 4;

VoxelProgram moving() {
  VoxelProgram program = builtin_voxel_program();
  for (int n = 1; n < Pictures; ++n) {
    program.views.push_back(program.views.back());
    program.views.back().origin[1] += 512;
  }
  program.craters = {{1, 32, 20, 6, 4}};
  return program;
}

/// What the viewer shows is the player's own picture.
void expect_picture(const VoxelSource& source, const VoxelProgram& program, const voxel_knobs& k,
                    int picture) {
  VoxelPlayer player(program, k);
  player.seek(picture);
  player.draw();
  const std::vector<std::uint64_t> words = player.machine().picture();
  ASSERT_EQ(source.watch().frame(), picture);
  for (int y = 0; y < 480; y += 3)
    for (int x = 0; x < 640; x += 3) {
      const auto dac = frame_scanout_core::pixel(words, y, x, k.store());
      const int wanted = dac.red >> 2 << 16 | dac.green >> 2 << 8 | dac.blue >> 2;
      const auto shown = source.picture()->colour(static_cast<std::size_t>(y) * 640 + x);
      ASSERT_EQ(static_cast<int>(shown), x < k.picture_width ? wanted : 0) << x << "," << y;
    }
}

TEST(VoxelSource, ShowsPictureAfterPictureAndGoesBack) {
  const VoxelProgram program = moving();
  const voxel_knobs k = voxel_engine().standard(&program);
  VoxelSource source(program, k, Pictures);
  for (int picture = 0; picture < 3; ++picture) {
    source.advance(source.clocks_left());
    expect_picture(source, program, k, picture);
  }
  for (const int picture : {1, 3}) {
    source.seek(picture);
    source.advance(source.clocks_left());
    expect_picture(source, program, k, picture);
  }
}

}  // namespace
}  // namespace racebeam
