// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/interval.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace racebeam {
namespace {

using testing::ElementsAre;

Stratum stratum(std::vector<double> values, int population) {
  Stratum one;
  one.values = std::move(values);
  one.frames.resize(one.values.size());
  std::iota(one.frames.begin(), one.frames.end(), 0);
  one.population = population;
  return one;
}

// Differences 2, -1, 2: 9 / (2 * 3 * 4) * (1 - 4 / 10) = 0.225; t(3) = 3.18245.
TEST(IntervalTest, MeanAndIntervalAreTheOnesDoneByHand) {
  const Estimate mean = mean_of({stratum({1, 3, 2, 4}, 10)});
  EXPECT_DOUBLE_EQ(mean.value, 2.5);
  EXPECT_NEAR(mean.half_width, 3.18245 * std::sqrt(0.225), 1e-5);
  EXPECT_EQ(mean.frames, 4);
  EXPECT_EQ(mean.population, 10);
  EXPECT_FALSE(mean.all());
  EXPECT_NEAR(mean_of({stratum({1, 3, 2, 4}, 10)}, 0.99).half_width, 5.84091 * std::sqrt(0.225),
              1e-5);
}

TEST(IntervalTest, SlowChangeCostsLittle) {
  std::vector<double> ramp(101);
  std::iota(ramp.begin(), ramp.end(), 0.0);
  // 100 differences of 1; the textbook's formula for random frames has sqrt(858.5 / 101) = 2.9.
  EXPECT_NEAR(mean_of({stratum(ramp, 1'000'000)}).half_width, 1.98397 * std::sqrt(1 / 202.0), 1e-4);
}

TEST(IntervalTest, AllFramesLeaveNoDoubt) {
  const Estimate mean = mean_of({stratum({1, 3, 2, 4}, 4)});
  EXPECT_TRUE(mean.all());
  EXPECT_EQ(mean.half_width, 0);
  EXPECT_TRUE(mean_of({stratum({5}, 1)}).all());
  EXPECT_EQ(mean_of({stratum({5}, 1)}).half_width, 0);
}

TEST(IntervalTest, OneFrameOfManySaysNothing) {
  const Estimate mean = mean_of({stratum({5}, 2)});
  EXPECT_EQ(mean.value, 5);
  EXPECT_TRUE(std::isinf(mean.half_width));
  EXPECT_FALSE(mean.differs_from(1e9));
  EXPECT_TRUE(std::isinf(mean_of({stratum({5}, 2), stratum({1, 2, 3}, 9)}).half_width));
}

TEST(IntervalTest, FewFramesAreAVerdictSoFar) {
  EXPECT_TRUE((Estimate{1, 0.1, 255, 11'135}).so_far());
  EXPECT_FALSE((Estimate{1, 0.1, 256, 11'135}).so_far());
  EXPECT_FALSE((Estimate{1, 0, 60, 60}).so_far());
}

TEST(IntervalTest, NoFramesAreNoNumber) {
  EXPECT_TRUE(std::isnan(mean_of({stratum({}, 9)}).value));
  EXPECT_TRUE(std::isnan(mean_of({}).value));
  EXPECT_FALSE(mean_of({stratum({}, 9)}).differs_from(0));
}

// Variances of the means 0.225 and 4 / (2 * 1 * 2) * (1 - 2 / 4) = 0.5; of their mean a quarter of
// the sum; degrees of freedom 0.725^2 / (0.225^2 / 3 + 0.5^2 / 1) = 1.9693.
TEST(IntervalTest, ScenesWeighTheSameWhateverTheirLength) {
  const Strata scenes = {stratum({1, 3, 2, 4}, 10), stratum({10, 12}, 4)};
  const Estimate mean = mean_of(scenes);
  EXPECT_DOUBLE_EQ(mean.value, (2.5 + 11) / 2);
  EXPECT_EQ(mean.frames, 6);
  EXPECT_EQ(mean.population, 14);
  // t(1.9693) lies between t(1) = 12.7 and t(2) = 4.3027, close to the second.
  const double t = mean.half_width / (std::sqrt(0.725) / 2);
  EXPECT_GT(t, 4.3027);
  EXPECT_LT(t, 4.45);
  const Estimate half_known = mean_of({stratum({1, 3, 2, 4}, 10), stratum({10, 12}, 2)});
  EXPECT_NEAR(half_known.half_width, 3.18245 * std::sqrt(0.225) / 2, 1e-5);
}

TEST(IntervalTest, DifferenceIsTakenFrameByFrame) {
  const Strata a = {stratum({100, 900, 400, 700}, 10)};
  const Strata b = {stratum({101, 903, 402, 704}, 10)};
  const Estimate change = difference_of(b, a);
  EXPECT_DOUBLE_EQ(change.value, 2.5);
  EXPECT_NEAR(change.half_width, 3.18245 * std::sqrt(0.225), 1e-5);
  EXPECT_TRUE(change.differs_from(0.9));
  EXPECT_FALSE(change.differs_from(1));
  EXPECT_DOUBLE_EQ(difference_of(a, b).value, -2.5);
}

TEST(IntervalTest, OnlyFramesThatBothHaveAreCompared) {
  Stratum a = stratum({10, 20, 30, 40}, 10), b = stratum({1, 2, 3}, 10);
  a.frames = {2, 4, 6, 8};
  b.frames = {4, 5, 8};
  const auto [of_b, of_a] = on_same_frames({b}, {a});
  EXPECT_THAT(of_a[0].frames, ElementsAre(4, 8));
  EXPECT_THAT(of_b[0].frames, ElementsAre(4, 8));
  EXPECT_THAT(of_a[0].values, ElementsAre(20, 40));
  EXPECT_THAT(of_b[0].values, ElementsAre(1, 3));
  EXPECT_DOUBLE_EQ(difference_of({a}, {b}).value, 28);
  EXPECT_EQ(difference_of({a}, {b}).frames, 2);
}

// R = 10 / 8; b - R a = -1, 1.5, -0.5 and differences 2.5, -2: 10.25 / (2 * 2 * 3) * (1 - 3 / 6).
TEST(IntervalTest, RatioIsOfMeansAndOfTheSameFrames) {
  const Strata a = {stratum({4, 10, 10}, 6)}, b = {stratum({4, 14, 12}, 6)};
  const Estimate ratio = ratio_of(b, a);
  EXPECT_DOUBLE_EQ(ratio.value, 1.25);
  EXPECT_NEAR(ratio.half_width, 4.30265 * std::sqrt(10.25 / 24) / 8, 1e-5);
  EXPECT_EQ(ratio_of({stratum({8, 20, 20}, 6)}, a).half_width, 0);  // twice in each frame
  EXPECT_TRUE(std::isnan(ratio_of(b, {stratum({0, 0, 0}, 6)}).value));
}

TEST(IntervalTest, BestOfManyIsHeldToMore) {
  EXPECT_DOUBLE_EQ(for_best_of(1), 0.95);
  EXPECT_DOUBLE_EQ(for_best_of(10), 0.995);
  EXPECT_DOUBLE_EQ(for_best_of(0), 0.95);
  EXPECT_DOUBLE_EQ(for_best_of(2, 0.9), 0.95);
}

TEST(IntervalTest, WorstIsTheFirstOfTheLargest) {
  Stratum one = stratum({3, -9, 7}, 10), other = stratum({7, 7}, 2);
  const Worst worst = worst_of({one, other});
  EXPECT_EQ(worst.value, 7);
  EXPECT_EQ(worst.scene, 0);
  EXPECT_EQ(worst.frame, 2);
  EXPECT_EQ(worst.frames, 5);
  EXPECT_FALSE(worst.all());
  EXPECT_TRUE(worst_of({other}).all());
  EXPECT_EQ(worst_of({stratum({-3, -2}, 9)}).value, -2);
  EXPECT_TRUE(std::isnan(worst_of({stratum({}, 9)}).value));
}

// 1 - 0.025^(1/256); five of twenty from Clopper and Pearson's published tables: 0.0866, 0.4910.
TEST(IntervalTest, SharesHaveClopperAndPearsonsInterval) {
  const Share none = share_of(0, 256, 11'135);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 1 / 256.0), 1e-12);
  const Share some = share_of(5, 20, 11'135);
  EXPECT_NEAR(some.low, 0.0866, 5e-5);
  EXPECT_NEAR(some.high, 0.4910, 5e-5);
  const Share every = share_of(256, 256, 11'135);
  EXPECT_NEAR(every.low, std::pow(0.025, 1 / 256.0), 1e-12);
  EXPECT_EQ(every.high, 1);
  const Share known = share_of(5, 20, 20);
  EXPECT_EQ(known.low, 0.25);
  EXPECT_EQ(known.high, 0.25);
}

TEST(IntervalTest, ShareWithAnyCountsFramesThatAreNotZero) {
  const Share share = share_with_any(stratum({0, 3, 0, 0.5}, 9));
  EXPECT_EQ(share.hits, 2);
  EXPECT_EQ(share.frames, 4);
  EXPECT_EQ(share.population, 9);
}

}  // namespace
}  // namespace racebeam
