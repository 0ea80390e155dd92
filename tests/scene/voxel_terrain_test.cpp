// The ground of voxel worlds: what functions and pictures make.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_terrain.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sc/voxel/voxel_world.h"
#include "tb/scene/value_noise.h"

namespace racebeam {
namespace {

constexpr vec3 Wide{256, 128, 128};

std::vector<voxel_column> unpacked(const std::vector<std::uint32_t>& words) {
  std::vector<voxel_column> columns;
  for (const std::uint32_t word : words) columns.push_back(unpacked_column(word));
  return columns;
}

void expect_columns(const std::vector<std::uint32_t>& words, const vec3& size) {
  ASSERT_EQ(words.size(), static_cast<std::size_t>(size[0] * size[1]));
  for (const voxel_column& c : unpacked(words)) {
    ASSERT_LE(c.low, c.middle);
    ASSERT_LE(c.middle, c.high);
    ASSERT_LE(c.high, std::min(size[2], 255));
  }
}

TEST(VoxelTerrainTest, TinyIsTheWorldOfTheVectors) {
  const std::vector<voxel_column> columns = unpacked(tiny_terrain({64, 64, 32}));
  ASSERT_EQ(columns.size(), 64u * 64u);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const voxel_column& c = columns[static_cast<std::size_t>(64 * y + x)];
      ASSERT_EQ(c.low, 4 + (7 * x + 13 * y) % 8 + (x == 20 && y == 30 ? 16 : 0));
      ASSERT_EQ(c.middle, c.low);
      ASSERT_EQ(c.high, c.low);
    }
  // As built: page 5.10.
  const voxel_world world(voxel_levels({64, 64, 32}, {1, 4, 1}), tiny_terrain({64, 64, 32}));
  EXPECT_EQ(world.bits_set(), 12409u);
}

TEST(VoxelTerrainTest, FunctionsFitAnyWorld) {
  for (const vec3& size : {Wide, vec3{64, 64, 16}, vec3{96, 160, 256}}) {
    expect_columns(tiny_terrain(size), size);
    expect_columns(hills_terrain(size, {}), size);
    expect_columns(canyon_terrain(size, {}), size);
  }
}

TEST(VoxelTerrainTest, NoiseRepeatsWithTheWorldAndIsSmooth) {
  const ValueNoise noise(256, 128, 64, 3, 5);
  double lowest = 1, highest = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const double here = noise.at(x, y);
      lowest = std::min(lowest, here);
      highest = std::max(highest, here);
      // The steepest that three octaves can be: 1.5 times a whole step in a cell of each.
      ASSERT_LT(std::abs(noise.at((x + 1) % 256, y) - here), 1.5 * 3 / 1.75 / 64);
      ASSERT_LT(std::abs(noise.at(x, (y + 1) % 128) - here), 1.5 * 3 / 1.75 / 64);
    }
  EXPECT_GE(lowest, 0);
  EXPECT_LE(highest, 1);
  EXPECT_LT(lowest, 0.35);
  EXPECT_GT(highest, 0.65);
}

TEST(VoxelTerrainTest, HillsFollowTheSeedAlone) {
  EXPECT_EQ(hills_terrain(Wide, {}), hills_terrain(Wide, {}));
  HillsTerrain other;
  other.seed = 2;
  EXPECT_NE(hills_terrain(Wide, {}), hills_terrain(Wide, other));
}

TEST(VoxelTerrainTest, HillsAreFrom4To100WithPostsAndRoofsIfAskedFor) {
  const vec3 size{512, 512, 128};
  HillsTerrain bare;
  bare.posts = 0;
  bare.caves = false;
  const std::vector<voxel_column> plain = unpacked(hills_terrain(size, bare));
  const auto by_low = [](const voxel_column& a, const voxel_column& b) { return a.low < b.low; };
  const auto ends = std::minmax_element(plain.begin(), plain.end(), by_low);
  EXPECT_GE(ends.first->low, 4);
  EXPECT_LE(ends.second->low, 100);
  EXPECT_LT(ends.first->low, 10);
  EXPECT_GT(ends.second->low, 75);

  HillsTerrain posts = bare;
  posts.posts = 900;
  const std::vector<voxel_column> posted = unpacked(hills_terrain(size, posts));
  int count = 0;
  for (std::size_t n = 0; n < plain.size(); ++n) {
    const int more = posted[n].low - plain[n].low;
    ASSERT_TRUE(more == 0 || (more >= 20 && more <= 40)) << more;
    count += more != 0;
  }
  EXPECT_NEAR(count, 512 * 512 / 900.0, 60);

  HillsTerrain caves = bare;
  caves.caves = true;
  int roofs = 0;
  for (const voxel_column& c : unpacked(hills_terrain(size, caves)))
    roofs += c.middle > c.low && c.high > c.middle;
  EXPECT_GT(roofs, 512 * 512 / 50);
  EXPECT_LT(roofs, 512 * 512 / 3);
}

TEST(VoxelTerrainTest, ACanyonHasItsCliffsAtSidesOfLargeVoxels) {
  const vec3 size{256, 64, 128};
  for (const int offset : {0, 5}) {
    CanyonTerrain how;
    how.offset = offset;
    const std::vector<voxel_column> columns = unpacked(canyon_terrain(size, how));
    for (int y = 0; y < 64; ++y) {
      const auto low = [&](int x) { return columns[static_cast<std::size_t>(256 * y + x)].low; };
      EXPECT_GE(low(63 + offset), 80);
      EXPECT_LE(low(66 + offset), 17);
      EXPECT_LE(low(189 + offset), 17);
      EXPECT_GE(low(192 + offset), 80);
    }
  }
}

GreyPicture grey(int width, int height, int bits, std::vector<std::uint16_t> pixels) {
  return {width, height, bits, std::move(pixels)};
}

TEST(VoxelTerrainTest, PicturesAreHeightsWithTheFarRowOnTop) {
  const GreyPicture low = grey(2, 2, 8, {0, 255, 100, 51});
  const std::vector<voxel_column> columns = unpacked(picture_terrain({2, 2, 128}, {&low}));
  EXPECT_EQ(columns[0].low, 50);  // 100 * 128 / 255
  EXPECT_EQ(columns[1].low, 26);
  EXPECT_EQ(columns[2].low, 0);
  EXPECT_EQ(columns[3].low, 128);
  const std::vector<voxel_column> high = unpacked(picture_terrain({2, 2, 256}, {&low}));
  EXPECT_EQ(high[0].low, 100);
  EXPECT_EQ(high[3].low, 255);
}

TEST(VoxelTerrainTest, SixteenBitsAreTheSameHeights) {
  const GreyPicture low = grey(2, 1, 16, {0x8000, 0xffff});
  const std::vector<voxel_column> columns = unpacked(picture_terrain({2, 1, 128}, {&low}));
  EXPECT_EQ(columns[0].low, 64);
  EXPECT_EQ(columns[1].low, 128);
}

TEST(VoxelTerrainTest, TwoMorePicturesAreASecondLayerAndOneMoreMaterials) {
  const GreyPicture low = grey(1, 1, 8, {20}), middle = grey(1, 1, 8, {120}),
                    high = grey(1, 1, 8, {200}), materials = grey(1, 1, 8, {5 * 32 + 3});
  const voxel_column c =
      unpacked(picture_terrain({1, 1, 256}, {&low, &middle, &high, &materials}))[0];
  EXPECT_EQ(c.low, 20);
  EXPECT_EQ(c.middle, 120);
  EXPECT_EQ(c.high, 200);
  EXPECT_EQ(c.low_material, 5);
  EXPECT_EQ(c.high_material, 5);
}

}  // namespace
}  // namespace racebeam
