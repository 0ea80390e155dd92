// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/frame_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAreArray;

std::vector<int> frames_to(int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

std::vector<int> first(std::vector<int> order, std::size_t count) {
  order.resize(count);
  return order;
}

/// The most frames from one of the first `n` to the next, around the end.
int widest_gap(const std::vector<int>& order, std::size_t n) {
  std::vector<int> sorted = first(order, n);
  std::sort(sorted.begin(), sorted.end());
  int gap = sorted.front() + static_cast<int>(order.size()) - sorted.back();
  for (std::size_t i = 1; i < n; ++i) gap = std::max(gap, sorted[i] - sorted[i - 1]);
  return gap;
}

TEST(FrameOrderTest, EachFrameComesExactlyOnce) {
  for (const int count : {0, 1, 2, 3, 64, 8191, 11'135, 16'383})
    for (const std::uint64_t seed : {0u, 1u, 2u, 77u}) {
      std::vector<int> order = frame_order(frames_to(count), seed);
      std::sort(order.begin(), order.end());
      EXPECT_EQ(order, frames_to(count)) << count << " frames, seed " << seed;
    }
}

// Stored sweeps go on with it. From exact fractions; u, 0.13388 and 0.75439, are the high halves of
// the first numbers of the 64-bit Mersenne twister.
TEST(FrameOrderTest, StaysTheSameForEver) {
  EXPECT_THAT(first(frame_order(frames_to(11'135), 1), 8),
              ElementsAre(1490, 7058, 4274, 9841, 2882, 8450, 5666, 98));
  EXPECT_THAT(first(frame_order(frames_to(11'135), 7), 8),
              ElementsAre(8400, 2832, 48, 5616, 9791, 4224, 1440, 7008));
  EXPECT_THAT(frame_order(frames_to(7), 7), ElementsAre(5, 1, 0, 3, 6, 2, 4));
}

TEST(FrameOrderTest, IsTheReversedCountInPowersOfTwo) {
  const std::vector<int> order = frame_order(frames_to(8), 5);
  const std::vector<int> reversed = {0, 4, 2, 6, 1, 5, 3, 7};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(order[i], (order[0] + reversed[i]) % 8);
}

TEST(FrameOrderTest, AnyFirstPartLiesEvenly) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const std::vector<int> order = frame_order(frames_to(11'135), seed);
    for (std::size_t n = 1, power = 1; n <= 600; ++n) {
      if (n == 2 * power) power = n;
      const int widest = (11'135 + static_cast<int>(power) - 1) / static_cast<int>(power);
      EXPECT_LE(widest_gap(order, n), widest) << n << " frames, seed " << seed;
    }
  }
}

TEST(FrameOrderTest, TakesOnlyFramesThatAreAllowed) {
  const std::vector<int> allowed = {3, 4, 5, 100, 101, 7'000};
  EXPECT_THAT(frame_order(allowed, 1), UnorderedElementsAreArray(allowed));
}

TEST(FrameOrderTest, EveryFrameIsAsLikelyAtEveryPlace) {
  constexpr int Seeds = 7'000;
  for (const std::size_t place : {0u, 1u, 4u}) {
    std::vector<int> times(7);
    for (std::uint64_t seed = 0; seed < Seeds; ++seed)
      ++times[static_cast<std::size_t>(frame_order(frames_to(7), seed)[place])];
    // 1,000 each; 5 standard deviations are 146.
    for (const int count : times) EXPECT_NEAR(count, Seeds / 7, 146) << "place " << place;
  }
}

}  // namespace
}  // namespace racebeam
