// The cores that a ray goes through take it where the closed form does, in as many clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "sc/voxel/voxel_walker_core.h"
#include "tests/voxel/rough_rays.h"
#include "tests/voxel/tiny_world.h"
#include "tests/voxel/walker_rig.h"

namespace racebeam {
namespace {

TEST(VoxelWalker, GoesWhereTheClosedFormGoesInAsManyClocks) {
  std::mt19937 random(7);
  std::array<int, 4> kinds{};
  for (int round = 0; round < 40; ++round) {
    const voxel_knobs k = any_knobs(random);
    const voxel_world world(voxel_levels(k), rough_columns(random, k));
    WalkerRig rig(world, k);
    for (int n = 0; n < 200; ++n) {
      const voxel_ray ray = any_ray(random, k);
      const voxel_limit limit{within(random, 1, 100), within(random, 1, 100)};
      voxel_walked walked, expected;
      const voxel_end end = rig.walk(ray, limit, walked);
      const voxel_end same = voxel_walk(world, k, ray, limit, expected);
      ASSERT_EQ(end.kind, same.kind) << "round " << round << ", ray " << n;
      if (same.kind != VoxelSky) {
        ASSERT_EQ(end.position, same.position);
      }
      ASSERT_EQ(walked.clocks, expected.clocks) << "round " << round << ", ray " << n;
      ASSERT_EQ(walked.fetches_by_level, expected.fetches_by_level);
      ASSERT_EQ(walked.words_by_level, expected.words_by_level);
      ASSERT_EQ(walked.descents, expected.descents);
      ASSERT_EQ(walked.moves, expected.moves);
      ASSERT_EQ(walked.samples, expected.samples);
      ++kinds[end.kind];
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 50) << "each way to end";
}

TEST(VoxelWalker, DrawsTheWorldTinyIn312737Clocks) {
  const voxel_world world = tiny_world(4);
  WalkerRig rig(world, {});
  voxel_walked walked;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const voxel_ray ray{
          {32 * 256 + 128, 2 * 256 + 64, 40 * 256},
          {(-6710880 + x * 209715) >> 8, 10066330 >> 8, (-838866 - y * 209715) >> 8}};
      EXPECT_EQ(rig.walk(ray, {100, 100}, walked).kind, VoxelHit);
    }
  EXPECT_EQ(walked.clocks, 312737u);
}

}  // namespace
}  // namespace racebeam
