// Where a voxel's bit is, and which are set.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_world.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/voxel/tiny_world.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Pair;

constexpr vec3 Wide{512, 512, 128}, Long{2048, 16384, 256}, Flat{1, 4, 1};

std::pair<std::uint32_t, int> word_and_bit(const vec3& size, int level, int x, int y, int z) {
  const voxel_place place = voxel_levels(size, Flat).place(level, x, y, z);
  return {place.word, place.bit};
}

std::vector<std::uint32_t> offsets(const voxel_levels& levels) {
  std::vector<std::uint32_t> all;
  for (int k = 0; k < levels.count(); ++k) all.push_back(levels.level(k).offset);
  return all;
}

TEST(VoxelLevels, CodesAreMortons) {
  EXPECT_EQ(voxel_morton(1, 0, 0), 1u);
  EXPECT_EQ(voxel_morton(0, 1, 0), 2u);
  EXPECT_EQ(voxel_morton(0, 0, 1), 4u);
  EXPECT_EQ(voxel_morton(7, 7, 7), 0x1ffu);
  EXPECT_EQ(voxel_morton(3, 5, 6), 0x1abu);
  EXPECT_EQ(voxel_morton(2, 3, 1), 0x1eu);
  EXPECT_EQ(voxel_morton(1023, 0, 0), 0x09249249u);
  EXPECT_EQ(voxel_morton(0, 0, 1023), 0x24924924u);
}

TEST(VoxelLevels, AxesOfTenBitsAreWovenBitByBit) {
  for (std::uint32_t value = 0; value < 1024; ++value) {
    std::uint32_t woven = 0;
    for (int n = 0; n < 10; ++n) woven |= (value >> n & 1) << 3 * n;
    ASSERT_EQ(voxel_morton(value, 0, 0), woven);
    ASSERT_EQ(voxel_morton(0, value, 0), woven << 1);
    ASSERT_EQ(voxel_morton(0, 0, value), woven << 2);
  }
}

TEST(VoxelLevels, FollowEachOtherInTheMemory) {
  const voxel_levels wide(Wide, Flat, 7), all(Long, Flat);
  EXPECT_THAT(offsets(wide),
              testing::ElementsAre(0, 262144, 294912, 299008, 299520, 299584, 299616));
  EXPECT_EQ(wide.words(), 299632u);
  EXPECT_EQ(wide.level(6).sides, (vec3{8, 2, 2}));
  EXPECT_THAT(offsets(all), testing::ElementsAre(0, 67108864, 75497472, 76546048, 76677120,
                                                 76693504, 76695552, 76696064, 76696192));
  EXPECT_EQ(all.words(), 76696224u);
}

TEST(VoxelLevels, AreAsManyAsTheShortestSideCanBeHalved) {
  EXPECT_EQ(voxel_levels(Wide, Flat).count(), 8);
  EXPECT_EQ(voxel_levels(Wide, Flat).level(7).sides, (vec3{4, 1, 1}));
  EXPECT_EQ(voxel_levels(Long, Flat).count(), 9);
  EXPECT_EQ(voxel_levels({64, 64, 32}, {1, 4, 1}).count(), 5);
  EXPECT_EQ(voxel_levels({64, 64, 32}, {1, 1, 1}).count(), 6);
}

TEST(VoxelLevels, FindTheBitsOfVoxels) {
  EXPECT_THAT(word_and_bit(Wide, 0, 0, 0, 0), Pair(0, 0));
  EXPECT_THAT(word_and_bit(Wide, 0, 511, 127, 127), Pair(262143, 31));
  EXPECT_THAT(word_and_bit(Wide, 0, 100, 50, 60), Pair(121034, 16));
  EXPECT_THAT(word_and_bit(Wide, 0, -1, -1, 0), Pair(16374, 27));
  EXPECT_THAT(word_and_bit(Wide, 1, 17, 33, 9), Pair(268320, 7));
  EXPECT_THAT(word_and_bit(Wide, 3, 12, 5, 7), Pair(299039, 6));
  EXPECT_THAT(word_and_bit(Wide, 6, 7, 1, 1), Pair(299618, 15));
  EXPECT_THAT(word_and_bit(Wide, 0, 600, 130, 5), Pair(184, 20));
  EXPECT_THAT(word_and_bit(Long, 0, 2047, 4095, 255), Pair(67108863, 31));
  EXPECT_THAT(word_and_bit(Long, 4, 100, 200, 10), Pair(76691907, 0));
}

TEST(VoxelLevels, GiveEachVoxelABitOfItsOwn) {
  const voxel_levels levels({96, 160, 32}, {1, 1, 1});
  std::set<std::pair<std::uint32_t, int>> bits;
  std::size_t voxels = 0;
  for (int k = 0; k < levels.count(); ++k) {
    const vec3& sides = levels.level(k).sides;
    for (int x = 0; x < sides[0]; ++x)
      for (int y = 0; y < sides[1]; ++y)
        for (int z = 0; z < sides[2]; ++z, ++voxels) {
          const voxel_place place = levels.place(k, x, y, z);
          ASSERT_LT(place.word, levels.words());
          bits.insert({place.word, place.bit});
        }
  }
  EXPECT_EQ(bits.size(), voxels);
}

TEST(VoxelLevels, RepeatTheWorldAndEndItBelowAndAbove) {
  const voxel_levels levels({96, 64, 32}, {1, 4, 1});
  std::mt19937 random(1);
  for (int n = 0; n < 1'000'000; ++n) {
    const int k = static_cast<int>(random() % static_cast<unsigned>(levels.count()));
    const vec3& sides = levels.level(k).sides;
    const int x = static_cast<int>(random() % 65536) - 32768;
    const int y = static_cast<int>(random() % 65536) - 32768;
    const int z = static_cast<int>(random() % 65536) - 32768;
    const voxel_place place = levels.place(k, x, y, z);
    ASSERT_EQ(place.inside, z >= 0 && z < sides[2]);
    // Slowly, and only with what lies above 0.
    int low_x = x, low_y = y, low_z = z;
    for (const auto& [value, side] :
         {std::pair(&low_x, sides[0]), std::pair(&low_y, sides[1]), std::pair(&low_z, sides[2])})
      *value -= side * static_cast<int>(std::floor(*value / static_cast<double>(side)));
    const voxel_place same = levels.place(k, low_x, low_y, low_z);
    ASSERT_EQ(place.word, same.word) << x << "," << y << "," << z << " of level " << k;
    ASSERT_EQ(place.bit, same.bit);
  }
}

TEST(VoxelLevels, SayTheNextGoodSize) {
  const auto fault = [](const vec3& size, const vec3& voxel) -> std::string {
    try {
      voxel_levels levels(size, voxel);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(Wide, Flat), "");
  EXPECT_THAT(fault({510, 512, 128}, Flat), HasSubstr("along x is 510, no multiple of 128"));
  EXPECT_THAT(fault({510, 512, 128}, Flat), HasSubstr("the next one is 512"));
  EXPECT_THAT(fault({512, 514, 128}, Flat),
              HasSubstr("along y is 514, no multiple of a voxel's 4"));
  EXPECT_THAT(fault({512, 512, 128}, {1, 3, 1}), HasSubstr("1, 2, 4, 8 or 16"));
  EXPECT_THAT(fault({512, 512, 128}, {1, 32, 1}), HasSubstr("1, 2, 4, 8 or 16"));
  EXPECT_EQ(voxel_levels({510, 512, 128}, {1, 4, 1}, 2).count(), 2) << "of sides 2 and 1";
}

std::uint32_t fnv(const std::vector<std::uint32_t>& words) {
  std::uint32_t hash = 2166136261u;
  for (const std::uint32_t word : words)
    for (int byte = 0; byte < 4; ++byte) hash = (hash ^ (word >> 8 * byte & 255)) * 16777619u;
  return hash;
}

TEST(VoxelWorld, TinyHasItsBits) {
  const voxel_world flat = tiny_world(4), cubes = tiny_world(1);
  EXPECT_EQ(flat.levels().count(), 5);
  EXPECT_EQ(flat.levels().words(), 1216u);
  EXPECT_EQ(flat.bits_set(), 12409u);
  EXPECT_EQ(fnv(flat.occupancy()), 0x298de96cu);
  EXPECT_EQ(cubes.levels().count(), 6);
  EXPECT_EQ(cubes.levels().words(), 4720u);
  EXPECT_EQ(cubes.bits_set(), 37038u);
  EXPECT_EQ(fnv(cubes.occupancy()), 0x34e9e09eu);
}

TEST(VoxelWorld, AVoxelIsOccupiedIfAnyUnitInItIsSolid) {
  std::mt19937 random(2);
  for (const vec3 voxel : {vec3{1, 1, 1}, vec3{1, 4, 1}, vec3{2, 4, 1}, vec3{4, 4, 4}}) {
    const voxel_levels levels({32, 48, 16}, voxel, 3);
    std::vector<std::uint32_t> columns;
    for (int n = 0; n < 32 * 48; ++n) {
      voxel_column c;
      c.low = static_cast<int>(random() % 6);
      c.middle = c.low + static_cast<int>(random() % 6);
      c.high = c.middle + static_cast<int>(random() % 5);
      columns.push_back(packed(c));
      ASSERT_EQ(packed(unpacked_column(packed(c))), packed(c));
    }
    const voxel_world world(levels, columns);
    for (int k = 0; k < levels.count(); ++k) {
      const vec3& sides = levels.level(k).sides;
      for (int x = 0; x < sides[0]; ++x)
        for (int y = 0; y < sides[1]; ++y)
          for (int z = 0; z < sides[2]; ++z) {
            bool solid = false;
            for (int i = 0; i < levels.side(k, 0); ++i)
              for (int j = 0; j < levels.side(k, 1); ++j)
                for (int h = 0; h < levels.side(k, 2); ++h)
                  solid |= world.column(x * levels.side(k, 0) + i, y * levels.side(k, 1) + j)
                               .solid(z * levels.side(k, 2) + h);
            ASSERT_EQ(world.occupied(k, x, y, z), solid) << k << ": " << x << "," << y << "," << z;
          }
    }
  }
}

}  // namespace
}  // namespace racebeam
