// The RTL of voxel_scan and voxel_shade beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/voxel/voxel_parameters.h"
#include "sc/voxel/voxel_scan.h"
#include "sc/voxel/voxel_shade.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {
namespace {

template <class Unit>
void expect_agreement(const voxel_knobs& k) {
  constexpr unsigned Seed = 1;
  constexpr int Clocks = 40'000;
  Unit unit("model", k);
  Lockstep lockstep("lockstep", Unit::unit_name, unit, voxel_parameters(k),
                    PluginMaker(voxel_parameters(k)).own(Unit::unit_name));
  UnitBench bench(unit, &lockstep.clk_i);
  RandomTraffic traffic(bench, LegalInputs({}), Seed);
  bench.between_edges([&] { traffic.next(); });
  bench.clock(Clocks);
  EXPECT_GE(lockstep.clocks(), std::uint64_t{Clocks});
  EXPECT_EQ(lockstep.differences(), 0u)
      << "seed " << Seed << "\n"
      << (lockstep.first() ? difference_table(*lockstep.first()) : "");
}

voxel_knobs small_picture(int shadows) {
  voxel_knobs k;
  k.picture_width = 8;
  k.picture_height = 2;
  k.shadows = shadows;
  return k;
}
TEST(VoxelScanLockstep, AgreesWithoutShadows) { expect_agreement<voxel_scan>(small_picture(0)); }
TEST(VoxelScanLockstep, AgreesWithShadows) { expect_agreement<voxel_scan>(small_picture(1)); }

voxel_knobs shading(int shading, int leaf, int sky, int debug_limits, const vec3& size,
                    int memory_clocks) {
  voxel_knobs k;
  k.shading = shading;
  k.leaf = leaf;
  k.sky = sky;
  k.debug_limits = debug_limits;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_y = 1;
  k.memory_clocks = memory_clocks;
  return k;
}
TEST(VoxelShadeLockstep, AgreesByHeight) { expect_agreement<voxel_shade>({}); }
TEST(VoxelShadeLockstep, AgreesBySlope) {
  expect_agreement<voxel_shade>(
      shading(VoxelShadingSlope, VoxelLeafMarch, VoxelSkyPlain, 0, {64, 64, 128}, 1));
}
TEST(VoxelShadeLockstep, AgreesInALargeWorld) {
  expect_agreement<voxel_shade>(
      shading(VoxelShadingSlope, VoxelLeafMarch, VoxelSkyGradient, 1, {2048, 16384, 256}, 8));
}
TEST(VoxelShadeLockstep, AgreesWithVoxelHitsInAnOddWorld) {
  expect_agreement<voxel_shade>(
      shading(VoxelShadingSlope, VoxelLeafVoxel, VoxelSkyGradient, 1, {96, 160, 8}, 2));
}
TEST(VoxelShadeLockstep, AgreesWithVoxelHitsByHeight) {
  expect_agreement<voxel_shade>(
      shading(VoxelShadingHeight, VoxelLeafVoxel, VoxelSkyGradient, 0, {48, 32, 16}, 1));
}

}  // namespace
}  // namespace racebeam
