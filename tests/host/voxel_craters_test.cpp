// Craters: how deep, what goes first, and what has changed.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_craters.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

namespace racebeam {
namespace {

constexpr vec3 Size{32, 48, 64};

std::vector<std::uint32_t> plain(const voxel_column& column) {
  return std::vector<std::uint32_t>(static_cast<std::size_t>(Size[0] * Size[1]), packed(column));
}

voxel_column at(const std::vector<std::uint32_t>& columns, int x, int y) {
  return unpacked_column(columns[static_cast<std::size_t>(y * Size[0] + x)]);
}

TEST(VoxelCraters, AreBowls) {
  std::vector<std::uint32_t> columns = plain({40, 40, 40, 3, 5});
  make_crater({0, 16, 20, 8, 12}, Size, columns);
  EXPECT_EQ(at(columns, 16, 20).low, 28);
  EXPECT_EQ(at(columns, 20, 20).low, 31);  // 12 * (64 - 16) / 64 less
  EXPECT_EQ(at(columns, 16, 13).low, 38);  // 12 * (64 - 49) / 64 less
  EXPECT_EQ(at(columns, 24, 20).low, 40);
  EXPECT_EQ(at(columns, 16, 12).low, 40);
  EXPECT_EQ(at(columns, 20, 20).low_material, 3);
  EXPECT_EQ(at(columns, 20, 20).high, at(columns, 20, 20).low);
}

TEST(VoxelCraters, TakeTheRoofFirstAndThenTheGround) {
  const auto middle_of = [](const voxel_column& column, int depth) {
    std::vector<std::uint32_t> columns = plain(column);
    make_crater({0, 3, 3, 4, depth}, Size, columns);
    return at(columns, 3, 3);
  };
  const voxel_column some = middle_of({10, 20, 30, 0, 0}, 4);
  EXPECT_EQ(some.low, 10);
  EXPECT_EQ(some.middle, 20);
  EXPECT_EQ(some.high, 26);
  const voxel_column through = middle_of({10, 20, 30, 0, 0}, 14);
  EXPECT_EQ(through.low, 6);
  EXPECT_EQ(through.middle, 6);
  EXPECT_EQ(through.high, 6);
  EXPECT_EQ(middle_of({10, 20, 30, 0, 0}, 50).low, 0);
}

TEST(VoxelCraters, SayWhatTheyHaveChangedWhereTheWorldRepeats) {
  std::mt19937 random(3);
  for (int n = 0; n < 200; ++n) {
    const VoxelCrater crater{0, static_cast<int>(random() % 100) - 50,
                             static_cast<int>(random() % 100) - 50,
                             1 + static_cast<int>(random() % 16), 9};
    std::vector<std::uint32_t> columns = plain({40, 40, 40, 0, 0});
    std::set<std::pair<int, int>> told;
    const std::vector<voxel_rectangle> changed = make_crater(crater, Size, columns);
    EXPECT_LE(changed.size(), 4u);
    for (const voxel_rectangle& r : changed) {
      ASSERT_TRUE(0 <= r.x_low && r.x_low < r.x_high && r.x_high <= Size[0]);
      ASSERT_TRUE(0 <= r.y_low && r.y_low < r.y_high && r.y_high <= Size[1]);
      for (int y = r.y_low; y < r.y_high; ++y)
        for (int x = r.x_low; x < r.x_high; ++x) ASSERT_TRUE(told.emplace(x, y).second) << "twice";
    }
    for (int y = 0; y < Size[1]; ++y)
      for (int x = 0; x < Size[0]; ++x) {
        // Its middle, seen from here, is in the nearest of the worlds.
        const auto nearest = [](int way, int side) {
          const int rest = voxel_wrapped(way, side);
          return std::min(rest, side - rest);
        };
        const int depth =
            dug(crater, nearest(crater.x - x, Size[0]), nearest(crater.y - y, Size[1]));
        ASSERT_EQ(at(columns, x, y).low, 40 - depth);
        if (depth) {
          ASSERT_TRUE(told.count({x, y}));
        }
      }
  }
}

}  // namespace
}  // namespace racebeam
