// Whether the stated intervals hold: 500 samples of figures that are known for all frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <random>
#include <string>

#include "sc/beam/engine.h"
#include "tb/bench/tlm_bench.h"
#include "tb/show/open_show.h"
#include "tb/sweep/frame_order.h"
#include "tb/sweep/sweep_file.h"
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

  const DemoFigures demo_ = demo_frames();
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

struct Point {
  const char* name;
  int knobs::*knob;
  int value;
};
void PrintTo(const Point& point, std::ostream* out) { *out << point.name; }

/// All frames of the demo that a sweep may take, of a point; a minute and a half.
class LongCoverageTest : public CoverageTest, public testing::WithParamInterface<Point> {
 protected:
  static constexpr std::array Counters = {"decisions", "bisection_steps", "emits", "rooms_entered",
                                          "starved_pixels"};

  static std::array<Figure, Counters.size()> figures_of(const knobs& k) {
    const std::vector<counter_info>& counted = beam_engine().counters;
    std::array<std::size_t, Counters.size()> places{};
    for (std::size_t n = 0; n < Counters.size(); ++n)
      while (counted.at(places[n]).name != std::string(Counters[n])) ++places[n];
    std::array<Figure, Counters.size()> figures;
    const Show show = open_show("demo");
    TlmBench chip({k, true});
    for (int frame = 0; frame < show.frames(); ++frame) {
      if (SweepFrames().skips(show.part(frame))) continue;
      chip.seek(frame);
      const ChipBench::Frame rendered = chip.render();
      for (std::size_t n = 0; n < Counters.size(); ++n)
        figures[n].push_back(static_cast<double>(rendered.stats->counters[places[n]]));
    }
    return figures;
  }
};

TEST_P(LongCoverageTest, MeansOf256FramesHoldThoseOfAllFrames) {
  knobs k;
  if (GetParam().knob) k.*GetParam().knob = GetParam().value;
  const auto figures = figures_of(k);
  ASSERT_EQ(figures[0].size(), 11'135u);
  double sum = 0;
  for (std::size_t n = 0; n < Counters.size(); ++n) {
    const double share = covered_mean(figures[n], 256);
    EXPECT_GE(share, 0.85) << Counters[n];
    sum += share;
  }
  EXPECT_GE(sum / Counters.size(), 0.93);
}

INSTANTIATE_TEST_SUITE_P(LongPoints, LongCoverageTest,
                         testing::Values(Point{"chip", nullptr, 0},
                                         Point{"hurry_64", &knobs::hurry_threshold, 64},
                                         Point{"stack_4", &knobs::interval_stack_depth, 4}),
                         [](const auto& info) { return info.param.name; });

TEST_F(CoverageTest, WholeSceneIsTheTruth) {
  const Figure& figure = demo_.figures[3];
  const int all = static_cast<int>(figure.size());
  const Estimate whole = mean_of({taken(figure, frame_order(indices(figure.size()), 9), all)});
  EXPECT_DOUBLE_EQ(whole.value, mean(figure));
  EXPECT_EQ(whole.half_width, 0);
}

}  // namespace
}  // namespace racebeam
