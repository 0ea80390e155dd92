// How rays go through the octree, what they hit, and what they cost.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_rays.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/voxel/tiny_world.h"

namespace racebeam {
namespace {

constexpr voxel_limit Hundred{100, 100}, Twenty{20, 20}, Forty{40, 40};

vec3 fixed(const std::array<double, 3>& values, double one) {
  return {static_cast<int>(values[0] * one), static_cast<int>(values[1] * one),
          static_cast<int>(values[2] * one)};
}
voxel_ray ray(const std::array<double, 3>& from, const std::array<double, 3>& towards) {
  return {fixed(from, 256), fixed(towards, 65536)};
}

struct Vector {
  voxel_ray ray;
  voxel_kind kind;
  int x, y;
  double z;
  std::uint64_t fetches, moves, descents, samples, clocks;
};

// Limits of 40, voxels of 1 x 4 x 1.
TEST(VoxelRays, MeetTheVectors) {
  const Vector vectors[] = {
      {ray({20.5, 10.25, 18}, {0, 0.5, -1 / 64.}), VoxelHit, 20, 30, 17.3672, 8, 3, 4, 3, 54},
      {ray({20.5, 10.25, 22}, {0, 0.5, -1 / 16.}), VoxelHit, 20, 30, 19.4688, 10, 4, 5, 3, 61},
      {ray({1.5, 1.5, 40}, {0.25, 0.25, -0.5}), VoxelHit, 17, 17, 7.5, 17, 8, 8, 4, 89},
      {ray({0, 0, 31}, {0.5, 0.5, -0.125}), VoxelHit, 29, 29, 7.625, 54, 33, 20, 13, 252},
      {ray({63.75, 63.75, 20}, {-0.5, -0.375, -1 / 16.}), VoxelHit, 52, 7, 10.5938, 48, 30, 17, 3,
       201},
      {ray({32, 32, 20}, {0.5, 0.25, 0.25}), VoxelSky, 0, 0, 0, 2, 2, 0, 0, 26},
      {ray({10.5, 50.5, 30}, {0, 0, -0.75}), VoxelHit, 10, 50, 3.5039, 19, 10, 8, 7, 106},
      {ray({5.25, 5.25, 12.5}, {0.75, 0, 0}), VoxelSky, 0, 0, 0, 63, 41, 22, 0, 248},
      {ray({30, 40, 100}, {-0.25, 0.125, -0.25}), VoxelHit, 3, 21, 9.5, 20, 10, 9, 2, 94},
      {ray({16, 16, 16}, {-0.5, 0.5, -0.25}), VoxelHit, 2, 29, 9.25, 21, 10, 10, 2, 97},
  };
  const voxel_world world = tiny_world(4);
  int n = 0;
  for (const Vector& v : vectors) {
    SCOPED_TRACE(n++);
    voxel_walked walked;
    const voxel_end end = voxel_walk(world, {}, v.ray, Forty, walked);
    EXPECT_EQ(end.kind, v.kind);
    if (v.kind == VoxelHit) {
      EXPECT_EQ(end.position[0] >> 8 & 63, v.x);
      EXPECT_EQ(end.position[1] >> 8 & 63, v.y);
      EXPECT_NEAR(end.position[2] / 256., v.z, 0.0001);
    }
    EXPECT_EQ(walked.fetches(), v.fetches);
    EXPECT_EQ(walked.moves, v.moves);
    EXPECT_EQ(walked.descents, v.descents);
    EXPECT_EQ(walked.samples, v.samples);
    EXPECT_EQ(walked.clocks, v.clocks);
  }
}

voxel_ray ray_of_picture(int x, int y) {
  return {{32 * 256 + 128, 2 * 256 + 64, 40 * 256},
          {(-6710880 + x * 209715) >> 8, 10066330 >> 8, (-838866 - y * 209715) >> 8}};
}

struct Picture {
  std::array<int, 3> kinds{};
  voxel_walked walked;
  std::uint32_t hash = 2166136261u;

  Picture(const voxel_world& world, const voxel_knobs& k, const voxel_limit& limit) {
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) {
        const voxel_end end = voxel_walk(world, k, ray_of_picture(x, y), limit, walked);
        const int kind = std::min<int>(end.kind, VoxelOuterLimit);  // whichever limit
        ++kinds[kind];
        for (const int byte :
             {kind, end.position[0] >> 8 & 63, end.position[1] >> 8 & 63, end.position[2] >> 8})
          hash = (hash ^ static_cast<unsigned>(byte & 255)) * 16777619u;
      }
  }
};

void expect(const Picture& p, const std::array<int, 3>& kinds,
            const std::array<std::uint64_t, 6>& counts, std::uint32_t hash) {
  const voxel_walked& w = p.walked;
  EXPECT_EQ(p.kinds, kinds);
  EXPECT_THAT((std::array<std::uint64_t, 6>{w.fetches(), w.moves, w.descents, w.raises, w.samples,
                                            w.clocks}),
              testing::ElementsAreArray(counts));
  EXPECT_EQ(p.hash, hash);
}

TEST(VoxelRays, DrawTheWorldTiny) {
  const voxel_world flat = tiny_world(4), cubes = tiny_world(1);
  voxel_knobs voxel;
  voxel.leaf = VoxelLeafVoxel;
  expect(Picture(flat, {}, Hundred), {0, 3072, 0}, {65674, 37028, 25574, 13286, 7797, 312737},
         0x8699f15a);
  expect(Picture(flat, {}, Twenty), {0, 2817, 255}, {62760, 35346, 24597, 12526, 7127, 301068},
         0xefa80cde);
  expect(Picture(cubes, {}, Hundred), {0, 3072, 0}, {95648, 55437, 37139, 21779, 3072, 406893},
         0x972f4545);
  expect(Picture(cubes, voxel, Hundred), {0, 3072, 0}, {88076, 50359, 34645, 19285, 0, 369883},
         0x2771c69d);
  expect(Picture(cubes, {}, Twenty), {0, 2299, 773}, {82550, 47703, 32548, 18195, 2299, 359865},
         0xfe2bfd69);
}

}  // namespace
}  // namespace racebeam
