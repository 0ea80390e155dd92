// Rays pass over nothing: against plain walks in double precision.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "tb/golden/voxel_golden.h"
#include "tb/scene/voxel_terrain.h"
#include "tests/voxel/rough_rays.h"

namespace racebeam {
namespace {

constexpr voxel_limit Wide{1023, 1023};

/// Smallest voxels that the ray is in for longer than 1/64 before t, in double precision.
std::set<vec3> voxels_before(const voxel_world& world, const voxel_ray& ray, double end) {
  constexpr double LeastWay = 1.0 / 64;
  std::set<vec3> voxels;
  std::array<double, 3> from, towards;
  double speed = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    from[n] = ray.origin[n] / 256.0;
    towards[n] = ray.direction[n] / 65536.0;
    speed += towards[n] * towards[n];
  }
  speed = std::sqrt(speed);
  const int top = world.levels().size()[2];
  double t = from[2] >= top ? (top - from[2]) / towards[2] : 0;
  vec3 voxel;
  for (int n = 0; n < 3; ++n)
    voxel[n] = static_cast<int>(std::floor((from[n] + towards[n] * t) / world.levels().side(0, n)));
  voxel[2] = std::min(voxel[2], world.levels().level(0).sides[2] - 1);
  while (t < end) {
    int axis = 0;
    double out = end;
    for (int n = 0; n < 3; ++n) {
      if (towards[n] == 0) continue;
      const double border = (voxel[n] + (towards[n] > 0)) * world.levels().side(0, n);
      if ((border - from[n]) / towards[n] >= out) continue;
      out = (border - from[n]) / towards[n];
      axis = n;
    }
    if ((out - t) * speed > LeastWay) voxels.insert(voxel);
    t = std::max(t, out);
    voxel[axis] += towards[axis] > 0 ? 1 : -1;
  }
  return voxels;
}

void expect_nothing_passed_over(int worlds, int rays) {
  std::mt19937 random(11);
  int looked = 0;
  for (int n = 0; n < worlds; ++n) {
    voxel_knobs k = any_knobs(random);
    k.leaf = VoxelLeafMarch;
    const voxel_world world(voxel_levels(k), rough_columns(random, k));
    for (int r = 0; r < rays; ++r) {
      voxel_ray ray = any_ray(random, k);
      for (int& way : ray.direction)
        if (voxel_parallel(way)) way = 0;
      if (ray.direction == vec3{}) continue;
      std::set<vec3> sampled;
      std::int64_t last = 0;
      const voxel_steps steps = [&](const voxel_step& step) {
        ASSERT_GE(step.t, last) << "t falls";
        if (step.done == voxel_step::Sample) sampled.insert(step.voxel);
        if (step.done != voxel_step::Hit) last = step.t;
      };
      voxel_walked walked;
      const voxel_end end = voxel_walk(world, k, ray, Wide, walked, &steps);
      if (end.kind == VoxelSky) continue;
      // The last 1/16 is left out: t has eight bits behind the point.
      const double until = static_cast<double>(end.t) / 256 - 1.0 / 16;
      for (const vec3& voxel : voxels_before(world, ray, until)) {
        if (!world.occupied(0, voxel[0], voxel[1], voxel[2])) continue;
        ++looked;
        ASSERT_TRUE(sampled.count(voxel)) << "world " << n << ", ray " << r << ": voxel "
                                          << voxel[0] << " " << voxel[1] << " " << voxel[2];
      }
    }
  }
  EXPECT_GT(looked, rays) << "rays that pass occupied voxels";
}

TEST(VoxelTraversal, NoOccupiedVoxelIsPassedOver) { expect_nothing_passed_over(40, 500); }
TEST(LongVoxelTraversal, NoOccupiedVoxelIsPassedOverByAMillionRays) {
  expect_nothing_passed_over(1000, 1000);
}

voxel_knobs cubes() {
  voxel_knobs k;
  k.size_x = k.size_y = 512;
  k.size_z = 128;
  k.voxel_y = 1;
  k.leaf = VoxelLeafVoxel;
  return k;
}

/// Whether a ray from (256, 256) is in a closed cell at some time.
bool touches(double x_way, int x, double y_way, int y) {
  double low = 0, high = 1e9;
  for (const auto& [way, at] : {std::pair(x_way, x), std::pair(y_way, y)}) {
    const double near = (at - 256) / way, far = (at + 1 - 256) / way;
    if (way == 0 && (at > 256 || at + 1 < 256)) return false;
    if (way == 0) continue;
    low = std::max(low, std::min(near, far));
    high = std::min(high, std::max(near, far));
  }
  return low <= high + 1e-9;
}

// From a corner of voxels along their corners and edges: which of the cells that a ray only touches
// it meets is left to rounding.
TEST(VoxelTraversal, RaysThroughCornersHitWhatTheyTouch) {
  const voxel_knobs k = cubes();
  const voxel_world world(voxel_levels(k), hills_terrain(k.size(), {}));
  const voxel_palette colours{};
  const VoxelGolden golden(k, world.columns(), colours, {});
  int rays = 0, others = 0;
  for (int a = -16; a <= 16; ++a)
    for (int b = -16; b <= 16; ++b)
      for (int c = 1; c <= 16; ++c) {
        if (a == 0 && b == 0) continue;
        const voxel_ray ray{{256 * 256, 256 * 256, 120 * 256}, {2048 * a, 2048 * b, -1024 * c}};
        voxel_walked walked;
        const voxel_end end = voxel_walk(world, k, ray, Wide, walked);
        ASSERT_EQ(end.kind, VoxelHit);
        const VoxelGolden::Hit exact = golden.hit({256, 256, 120}, {a / 32.0, b / 32.0, -c / 64.0});
        ASSERT_FALSE(exact.sky);
        ++rays;
        const auto cell = [](int at) { return voxel_wrapped(at >> 8, 512); };
        if (cell(end.position[0]) == exact.x && cell(end.position[1]) == exact.y) continue;
        others += !touches(a / 32.0, end.position[0] >> 8, b / 32.0, end.position[1] >> 8);
      }
  EXPECT_EQ(rays, 17408);
  EXPECT_LE(others, rays / 500) << "neither the exact cell nor one that the ray touches";
}

void expect_ends(int rays) {
  std::mt19937 random(5);
  std::array<int, 4> kinds{};
  for (int n = 0; n < 20; ++n) {
    const voxel_knobs k = any_knobs(random);
    const voxel_world world(voxel_levels(k), rough_columns(random, k));
    for (int r = 0; r < rays / 20; ++r) {
      voxel_walked walked;
      ++kinds[voxel_walk(world, k, any_ray(random, k), Wide, walked).kind];
      ASSERT_LE(walked.moves, 1024u);
    }
  }
  EXPECT_GT(kinds[VoxelHit], rays / 10);
}

TEST(VoxelTraversal, EveryRayEnds) { expect_ends(100'000); }
TEST(LongVoxelTraversal, TenMillionRaysEnd) { expect_ends(10'000'000); }

}  // namespace
}  // namespace racebeam
