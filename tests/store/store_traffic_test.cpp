// What a write buffer's depth costs, in figures of an independent model of the same rules.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/store_traffic.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "tests/store/four_clocks.h"

namespace racebeam {
namespace {

store_knobs with(int depth, int write_policy = WritePolicySync, int when_full = WhenFullStall) {
  store_knobs k;
  k.write_buffer_depth = depth;
  k.write_policy = write_policy;
  k.when_full = when_full;
  return k;
}

/// 320 x 240 pixels that all take the same clocks.
StoreTraffic even(int clocks, const store_knobs& k) {
  return store_traffic(
      320 * 240, [clocks](int) { return clocks; }, k);
}

TEST(StoreTrafficTest, DepthsCostWhatTheirTableSays) {
  struct Row {
    int depth;
    const char* waited[4];
  };
  constexpr int Clocks[] = {17, 19, 23, 35};
  constexpr Row Table[] = {
      {1, {"557.901", "586.229", "469.133", "461.276"}},
      {8, {"233.092", "221.049", "165.814", "106.906"}},
      {16, {"112.999", "99.674", "65.182", "20.195"}},
      {24, {"56.555", "44.907", "19.835", "0.000"}},
      {30, {"30.536", "20.186", "0.811", "0.000"}},
      {31, {"27.027", "16.858", "0.000", "0.000"}},
      {32, {"23.728", "13.715", "0.000", "0.000"}},
      {38, {"6.906", "0.000", "0.000", "0.000"}},
      {40, {"2.287", "0.000", "0.000", "0.000"}},
      {42, {"0.000", "0.000", "0.000", "0.000"}},
      {48, {"0.000", "0.000", "0.000", "0.000"}},
      {64, {"0.000", "0.000", "0.000", "0.000"}},
  };
  for (const Row& row : Table)
    for (int n = 0; n < 4; ++n) {
      const auto traffic = even(Clocks[n], with(row.depth));
      EXPECT_EQ(fmt::format("{:.3f}", traffic.waited_percent()), row.waited[n])
          << "depth " << row.depth << ", " << Clocks[n] << " clocks a pixel";
      EXPECT_EQ(traffic.clocks, 76'800u * Clocks[n]);
      EXPECT_EQ(traffic.lost, 0u);
    }
}

// 704 = 800 - 96 clocks lie between two times to write. A word put in the last clock of one is in
// the buffer, too.
TEST(StoreTrafficTest, NothingWaitsIfAllThatComesBetweenTwoSyncsFits) {
  for (const int clocks : {11, 17, 19, 23, 35, 88}) {
    const int depth = 704 / clocks + 1;
    EXPECT_EQ(even(clocks, with(depth)).waited, 0u) << clocks << " clocks a pixel";
    EXPECT_GT(even(clocks, with(depth - 1)).waited, 0u) << clocks << " clocks a pixel";
  }
}

TEST(StoreTrafficTest, DroppingNeverWaitsAndLosesWhereStallingWaits) {
  for (const int depth : {1, 30, 31, 64}) {
    const auto traffic = even(23, with(depth, WritePolicySync, WhenFullDrop));
    EXPECT_EQ(traffic.waited, 0u);
    EXPECT_EQ(traffic.lost > 0, depth < 31) << "depth " << depth;
    EXPECT_EQ(traffic.lost % depth, 0u) << "all that it holds at once";
  }
}

class FourSpheres : public testing::Test {
 protected:
  StoreTraffic drawn(const store_knobs& k) const {
    return store_traffic(
        static_cast<int>(clocks.size()), [this](int pixel) { return clocks[pixel]; }, k);
  }
  const std::vector<int> clocks = FourClocks::all();
};

TEST_F(FourSpheres, TakeTheClocksThatTheirVectorsSay) {
  EXPECT_EQ(std::accumulate(clocks.begin(), clocks.end(), 0), 9'000'673);
  const auto at = [&](int x, int y) { return clocks[y * FourClocks::Width + x]; };
  EXPECT_EQ(at(0, 0), 35);
  EXPECT_EQ(at(200, 240), 76);
  EXPECT_EQ(at(256, 190), 77);
  EXPECT_EQ(at(396, 380), 44) << "the light";
}

TEST_F(FourSpheres, WaitAndLoseByDepth) {
  struct Row {
    int depth;
    const char *waited, *lost;
  };
  for (const Row& row : std::vector<Row>{{1, "444.19", "83.23"},
                                         {2, "335.75", "79.52"},
                                         {4, "211.63", "72.24"},
                                         {8, "98.61", "69.62"},
                                         {16, "18.13", "66.26"},
                                         {24, "0.00", "0.00"}}) {
    const auto stalled = drawn(with(row.depth));
    EXPECT_EQ(fmt::format("{:.2f}", stalled.waited_percent()), row.waited) << row.depth;
    const auto dropped = drawn(with(row.depth, WritePolicySync, WhenFullDrop));
    EXPECT_EQ(fmt::format("{:.2f}", dropped.lost_percent()), row.lost) << row.depth;
  }
}

TEST_F(FourSpheres, WaitForBlankingWithOneEntry) {
  EXPECT_EQ(fmt::format("{:.2f}", drawn(with(1, WritePolicyBlanking)).waited_percent()), "202.55");
}

}  // namespace
}  // namespace racebeam
