// What is built of columns, and in how many clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_build.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/voxel/plain_build.h"
#include "tests/voxel/tiny_world.h"

namespace racebeam {
namespace {

constexpr vec3 Wide{512, 512, 128};

/// Ground of the same height everywhere.
voxel_world flat_world(const vec3& size, const vec3& voxel, int levels, int low) {
  voxel_world world(voxel_levels(size, voxel, levels));
  voxel_column column;
  column.low = column.middle = column.high = low;
  for (std::uint32_t& word : world.columns()) word = packed(column);
  return world;
}

TEST(VoxelBuild, ClearsABitOfAVoxelColumnInTwoClocks) {
  for (const auto& [voxel, clocks] : {std::pair(vec3{1, 4, 1}, 16'777'216u),
                                      {vec3{2, 4, 1}, 8'388'608u},
                                      {vec3{1, 1, 1}, 67'108'864u}}) {
    voxel_world world(voxel_levels(Wide, voxel, 7));
    EXPECT_EQ(voxel_clear(world, {0, 0, 512, 512}), clocks);
  }
}

// 512 x 512 columns: a read, 128 heights, and a write of each that is solid.
TEST(VoxelBuild, FillsByColumnsWhateverTheVoxel) {
  for (const vec3 voxel : {vec3{1, 4, 1}, vec3{2, 4, 1}, vec3{1, 1, 1}}) {
    voxel_world world = flat_world(Wide, voxel, 7, 30);
    EXPECT_EQ(voxel_fill(world, {0, 0, 512, 512}), 262'144u * (2 + 128 + 2 * 30));
  }
}

// The first child decides where there is one; above the ground eight are looked at.
TEST(VoxelBuild, LooksAtChildrenUntilOneIsThere) {
  voxel_world world = flat_world(Wide, {1, 4, 1}, 7, 30);
  const voxel_built built = voxel_build(world);
  std::uint64_t up = 0;
  for (int k = 1; k < 7; ++k) {
    const vec3& sides = world.levels().level(k).sides;
    const int solid = (30 + (1 << k) - 1) >> k;
    up += static_cast<std::uint64_t>(sides[0] * sides[1] * (solid * 4 + (sides[2] - solid) * 18));
  }
  EXPECT_EQ(built.up, up);
  EXPECT_EQ(built.clocks, built.clear + built.fill + up);
  EXPECT_EQ(built.columns, 262'144u);
  EXPECT_NEAR(static_cast<double>(built.clocks), 83.84e6, 1e6) << "of hills as high on average";
}

TEST(VoxelBuild, GivesTheWordsAndClocksOfOneVoxelByVoxel) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const vec3 voxel{1 << within(random, 0, 2), 1 << within(random, 0, 2),
                     1 << within(random, 0, 2)};
    const int levels = within(random, 1, 4);
    vec3 size{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      size[axis] = within(random, 1, axis == 2 ? 1 : 3) * voxel[axis] << (levels + 1);
    voxel_world world(voxel_levels(size, voxel, levels));
    for (std::uint32_t& word : world.columns()) word = any_column(random, size[2]);
    voxel_world plain = world;
    for (int n = 0; n < 4; ++n) {
      const int memory_clocks = within(random, 1, 8);
      const voxel_rectangle part = any_rectangle(random, size);
      const voxel_built built = voxel_build(world, part, memory_clocks);
      const PlainBuild expected(plain, part, memory_clocks);
      ASSERT_EQ(world.occupancy(), plain.occupancy());
      ASSERT_EQ(built.clear, expected.clear);
      ASSERT_EQ(built.fill, expected.fill);
      ASSERT_EQ(built.up, expected.up);
      ASSERT_EQ(built.columns, expected.columns);
    }
  }
}

TEST(VoxelBuild, ChangedRectanglesAreAsInABuildFromScratch) {
  std::mt19937 random(18);
  for (const vec3 voxel : {vec3{1, 4, 1}, vec3{2, 2, 2}}) {
    voxel_world world(voxel_levels({64, 96, 32}, voxel, 4));
    voxel_build(world);
    for (int n = 0; n < 100; ++n) {
      const voxel_rectangle part = any_rectangle(random, world.levels().size());
      change(world, part, random);
      voxel_build(world, part);
      const voxel_world scratch(world.levels(), world.columns());
      ASSERT_EQ(world.occupancy(), scratch.occupancy()) << "change " << n;
    }
  }
}

TEST(VoxelBuild, HolesLeaveNothingBehind) {
  voxel_world world = tiny_world(4);
  world.columns()[world.column_address(20, 30)] = 0;
  voxel_build(world, {20, 30, 21, 31});
  EXPECT_FALSE(world.occupied(0, 20, 7, 19));
  EXPECT_FALSE(world.occupied(1, 10, 3, 9));
  EXPECT_TRUE(world.occupied(0, 20, 7, 3)) << "by the columns beside the hole";
}

TEST(VoxelBuild, FillBeforeClearLosesWhatOtherColumnsSet) {
  const voxel_world good = tiny_world(4);
  voxel_world early(good.levels());
  early.columns() = good.columns();
  const voxel_rectangle all{0, 0, 64, 64};
  voxel_fill(early, all);
  voxel_clear(early, all);
  voxel_up(early, all);
  EXPECT_NE(early.occupancy(), good.occupancy());
  // No barrier: each column of a voxel clears, then fills.
  voxel_world loose(good.levels());
  loose.columns() = good.columns();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      for (int z = 0; z < 32; ++z) {
        const voxel_place at = loose.levels().place(0, x, y / 4, z);
        loose.occupancy()[at.word] &= ~(1u << at.bit);
        if (loose.column(x, y).solid(z)) loose.occupancy()[at.word] |= 1u << at.bit;
      }
    }
  voxel_up(loose, all);
  EXPECT_NE(loose.occupancy(), good.occupancy());
  EXPECT_LT(loose.bits_set(), good.bits_set());
}

TEST(VoxelBuild, RefusesWhatIsNotInTheWorld) {
  voxel_world world = tiny_world(4);
  for (const voxel_rectangle& bad :
       {voxel_rectangle{0, 0, 65, 64}, {0, 0, 64, 65}, {5, 0, 5, 9}, {0, 9, 4, 3}, {-1, 0, 4, 4}})
    EXPECT_THROW(voxel_build(world, bad), std::invalid_argument);
  try {
    voxel_build(world, {8, 0, 65, 64});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("columns 8..65 by 0..64 cannot be built"));
    EXPECT_THAT(error.what(), testing::HasSubstr("in 0..64 by 0..64"));
  }
}

}  // namespace
}  // namespace racebeam
