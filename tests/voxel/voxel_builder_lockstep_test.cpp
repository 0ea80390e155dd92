// The RTL of voxel_builder beside its model, on random traffic, in small worlds.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/voxel/voxel_builder.h"
#include "sc/voxel/voxel_parameters.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {
namespace {

/// Most rectangles are in the world or a little beyond it.
LegalInputs near_world(const voxel_knobs& k) {
  const auto up_to = [](int most) {
    return [most](std::uint64_t raw) {
      return raw % 16 ? raw / 16 % (static_cast<unsigned>(most) + 1) : raw;
    };
  };
  return LegalInputs({{"rect_x_low_i", up_to(k.size_x - 1)},
                      {"rect_y_low_i", up_to(k.size_y - 1)},
                      {"rect_x_high_i", up_to(k.size_x + 1)},
                      {"rect_y_high_i", up_to(k.size_y + 1)}});
}

void expect_agreement(const vec3& size, const vec3& voxel, int levels, int memory_clocks) {
  constexpr unsigned Seed = 1;
  constexpr int Clocks = 100'000;
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.levels = levels;
  k.memory_clocks = memory_clocks;
  voxel_builder unit("model", k);
  Lockstep lockstep("lockstep", "voxel_builder", unit, voxel_parameters(k),
                    PluginMaker(voxel_parameters(k)).own("voxel_builder"));
  UnitBench bench(unit, &lockstep.clk_i);
  RandomTraffic traffic(bench, near_world(k), Seed);
  int builds = 0;  // that went to their end
  bench.between_edges([&] {
    builds += bench["done_o"].value() && bench["state_o"].value() != VoxelBuilderIdle;
    traffic.next();
  });
  bench.clock(Clocks);
  EXPECT_GE(builds, 10);
  EXPECT_GE(lockstep.clocks(), std::uint64_t{Clocks});
  EXPECT_EQ(lockstep.differences(), 0u)
      << "seed " << Seed << "\n"
      << (lockstep.first() ? difference_table(*lockstep.first()) : "");
}

TEST(VoxelBuilderLockstep, AgreesOnFlatVoxels) { expect_agreement({8, 16, 8}, {1, 4, 1}, 9, 1); }
TEST(VoxelBuilderLockstep, AgreesOnCubesOfAnOddWorld) {
  expect_agreement({12, 20, 8}, {1, 1, 1}, 3, 2);
}
TEST(VoxelBuilderLockstep, AgreesOnLargeVoxelsWithASlowMemory) {
  expect_agreement({4, 16, 32}, {2, 8, 16}, 2, 8);
}
TEST(VoxelBuilderLockstep, AgreesOnOneLevel) { expect_agreement({5, 6, 16}, {1, 2, 1}, 1, 1); }

}  // namespace
}  // namespace racebeam
