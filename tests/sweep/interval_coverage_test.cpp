// Whether the stated intervals hold: 500 samples of figures that are known for all frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "tb/sweep/frame_order.h"
#include "tests/sweep/demo_frames.h"

namespace racebeam {
namespace {

constexpr int Starts = 500;

/// Those with the frames of a scene in each of many orders.
class CoverageTest : public testing::Test {
 protected:
  using Figure = std::vector<double>;

  static std::vector<int> indices(std::size_t count) {
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  /// The share of starts whose interval holds `truth`.
  template <class EstimateOf>
  double covered(std::size_t frames, double truth, const EstimateOf& estimate_of) {
    int hits = 0;
    for (int start = 0; start < Starts; ++start)
      hits += !estimate_of(frame_order(indices(frames), static_cast<std::uint64_t>(start)))
                   .differs_from(truth);
    return double(hits) / Starts;
  }

  double covered_mean(const Figure& figure, int n) {
    return covered(figure.size(), mean(figure), [&](const std::vector<int>& order) {
      return mean_of({taken(figure, order, n)});
    });
  }

  const DemoFrames demo_ = demo_frames();
};

TEST_F(CoverageTest, HasTheDemo) {
  ASSERT_EQ(demo_.names.size(), 6);
  EXPECT_EQ(demo_.figures[0].size(), 3'712);
}

TEST_F(CoverageTest, MeansOf256FramesOfTheDemo) {
  double sum = 0;
  for (std::size_t figure = 1; figure < demo_.names.size(); ++figure) {
    const double share = covered_mean(demo_.figures[figure], 256);
    EXPECT_GE(share, 0.85) << demo_.names[figure];
    sum += share;
  }
  EXPECT_GE(sum / 5, 0.93);
}

TEST_F(CoverageTest, ChangesOf256FramesOfTheDemo) {
  double sum = 0;
  for (const std::size_t figure : {2u, 3u}) {
    const Figure &base = demo_.figures[figure], &other = demo_.figures[figure + 2];
    const double difference =
        covered(base.size(), mean(other) - mean(base), [&](const std::vector<int>& order) {
          return difference_of({taken(other, order, 256)}, {taken(base, order, 256)});
        });
    const double ratio =
        covered(base.size(), mean(other) / mean(base), [&](const std::vector<int>& order) {
          return ratio_of({taken(other, order, 256)}, {taken(base, order, 256)});
        });
    EXPECT_GE(difference, 0.85) << demo_.names[figure];
    EXPECT_GE(ratio, 0.85) << demo_.names[figure];
    sum += difference + ratio;
  }
  EXPECT_GE(sum / 4, 0.93);
}

// Frames that are not alike their neighbours: the interval must not live from smoothness. 95 % to
// four standard deviations of 1,000 scenes.
TEST_F(CoverageTest, NoiseIsCoveredAsOftenAsIsSaid) {
  constexpr int Scenes = 1'000;
  std::mt19937_64 random(1);
  Figure figure(1'000);
  for (const int n : {8, 16, 32, 64, 256}) {
    int hits = 0;
    for (int scene = 0; scene < Scenes; ++scene) {
      for (double& value : figure) value = static_cast<double>(random() >> 40);
      const std::vector<int> order = frame_order(indices(figure.size()), random());
      hits += !mean_of({taken(figure, order, n)}).differs_from(mean(figure));
    }
    EXPECT_NEAR(hits, 950, 28) << n << " frames";
  }
}

TEST_F(CoverageTest, ChangesAreSeenThatMeansHide) {
  const Figure &base = demo_.figures[2], &other = demo_.figures[4];
  const std::vector<int> order = frame_order(indices(base.size()), 1);
  const Strata a = {taken(base, order, 256)}, b = {taken(other, order, 256)};
  EXPECT_LT(mean_of(b).low(), mean_of(a).high());  // the intervals overlap
  EXPECT_GT(mean_of(b).high(), mean_of(a).low());
  EXPECT_LT(difference_of(b, a).high(), 0);
  EXPECT_LT(ratio_of(b, a).high(), 1);
}

TEST_F(CoverageTest, WholeSceneIsTheTruth) {
  const Figure& figure = demo_.figures[3];
  const int all = static_cast<int>(figure.size());
  const Estimate whole = mean_of({taken(figure, frame_order(indices(figure.size()), 9), all)});
  EXPECT_DOUBLE_EQ(whole.value, mean(figure));
  EXPECT_EQ(whole.half_width, 0);
}

}  // namespace
}  // namespace racebeam
