// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/racing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tb/sweep/frame_order.h"
#include "tests/sweep/demo_frames.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::IsSupersetOf;

TEST(RacingTest, RungsGrowByAThirdOrAHalfUpToTheSample) {
  EXPECT_THAT(rungs(256), ElementsAre(16, 24, 32, 48, 64, 96, 128, 192, 256));
  EXPECT_THAT(rungs(100), ElementsAre(16, 24, 32, 48, 64, 100));
  EXPECT_THAT(rungs(17), ElementsAre(17));
  EXPECT_THAT(rungs(16), ElementsAre(16));
  EXPECT_THAT(rungs(5), ElementsAre(5));
}

Candidate with_cells(const std::string& name, double cells, double flip_flops) {
  return {name, {{Reading::Exact, cells, {}}, {Reading::Exact, flip_flops, {}}}};
}

TEST(RacingTest, SaysWhoStopsAndWhy) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min},
                                   {"flip_flops", GoalKind::Limit, {}, 500.5}};
  std::vector<Candidate> points = {with_cells("p3", 6, 400), with_cells("p17", 5, 400),
                                   with_cells("p20", 4, 501), with_cells("chip", 7, 400)};
  points[3].base = true;
  const std::vector<Stop> stopped = stops(points, goals, 16, Confidence);
  ASSERT_EQ(stopped.size(), 2);  // not the base
  EXPECT_EQ(stopped[0].point, 0);
  EXPECT_EQ(stopped[0].by, 1);
  EXPECT_EQ(stopped[0].why, "dominated by p17 after 16 frames");
  EXPECT_EQ(stopped[1].point, 2);
  EXPECT_EQ(stopped[1].by, -1);
  EXPECT_EQ(stopped[1].why, "flip_flops beyond its limit after 16 frames");
}

/// A sweep whose figures are known for all frames: a figure of the demo, more or less of it by
/// point and, at random, by frame. The more cells, the less, roughly; the smaller the `spread`, the
/// more of the points are on the front, or nearly so.
class KnownSweep {
 public:
  KnownSweep(const std::vector<double>& truth, double spread, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return double(random() >> 8) / double(1 << 24); };
    for (int point = 0; point < 40; ++point) {
      const double size = uniform(), luck = spread * uniform();
      cells_.push_back(std::floor(6'000 + 1'000 * size));
      std::vector<double> values;
      for (const double value : truth)
        values.push_back(std::floor(value * (1.5 - size + luck * luck) * (0.7 + 0.6 * uniform())));
      frames_.push_back(std::move(values));
    }
  }

  std::size_t size() const { return cells_.size(); }
  Candidate candidate(std::size_t point, const std::vector<int>& order, int n) const {
    return {std::to_string(point),
            {{Reading::Sampled, 0, {taken(frames_[point], order, n)}},
             {Reading::Exact, cells_[point], {}}}};
  }

 private:
  std::vector<double> cells_;
  std::vector<std::vector<double>> frames_;
};

const std::vector<Goal> Goals = {{"starved", GoalKind::Min}, {"cells", GoalKind::Min}};

std::vector<std::size_t> front_of_all_frames(const KnownSweep& sweep,
                                             const std::vector<int>& order) {
  std::vector<Candidate> points;
  for (std::size_t point = 0; point < sweep.size(); ++point)
    points.push_back(sweep.candidate(point, order, static_cast<int>(order.size())));
  const std::vector<Verdict> verdicts = judge(points, Goals, Confidence);
  std::vector<std::size_t> front;
  for (std::size_t point = 0; point < sweep.size(); ++point)
    if (verdicts[point].standing == Verdict::Front) front.push_back(point);
  return front;
}

struct Race {
  std::vector<std::size_t> left;
  double frames = 0;  // rendered, of those without racing
};

Race race(const KnownSweep& sweep, const std::vector<int>& order, int sample) {
  Race race;
  std::vector<bool> stopped(sweep.size());
  int before = 0;
  for (const int rung : rungs(sample)) {
    std::vector<Candidate> points;
    for (std::size_t point = 0; point < sweep.size(); ++point) {
      points.push_back(sweep.candidate(point, order, rung));
      points.back().stopped = stopped[point];
      if (!stopped[point]) race.frames += rung - before;
    }
    before = rung;
    for (const Stop& stop : stops(points, Goals, rung, Confidence)) stopped[stop.point] = true;
  }
  race.frames /= double(sweep.size()) * sample;
  for (std::size_t point = 0; point < sweep.size(); ++point)
    if (!stopped[point]) race.left.push_back(point);
  return race;
}

class Races : public testing::TestWithParam<std::size_t> {
 protected:
  Races() : figure_(demo_frames().figures[GetParam()]), order_(order_of(figure_, 1)) {}

  static std::vector<int> order_of(const std::vector<double>& figure, std::uint64_t seed) {
    std::vector<int> indices(figure.size());
    std::iota(indices.begin(), indices.end(), 0);
    return frame_order(indices, seed);
  }

  const std::vector<double> figure_;
  const std::vector<int> order_;
};

TEST_P(Races, LoseNoPointOfTheFrontAndSaveFrames) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const KnownSweep sweep(figure_, 1, seed);
    const std::vector<std::size_t> front = front_of_all_frames(sweep, order_);
    EXPECT_GE(front.size(), 3);
    const Race raced = race(sweep, order_, 256);
    EXPECT_THAT(raced.left, IsSupersetOf(front));
    EXPECT_LT(raced.left.size(), sweep.size());
    EXPECT_LT(raced.frames, 0.75);
  }
}

// 95 % for each point, by all looks at it. Wide sweeps have 13 points of 40 on the front, dense
// ones 33, and the others close behind.
TEST_P(Races, StopFewerThanOneOfTwentyPointsOfTheFront) {
  constexpr unsigned Sweeps = 10;
  for (const double spread : {1.0, 0.15}) {
    std::size_t lost = 0, all = 0;
    for (unsigned seed = 1; seed <= Sweeps; ++seed) {
      const KnownSweep sweep(figure_, spread, seed);
      const std::vector<int> order = order_of(figure_, seed);
      const std::vector<std::size_t> front = front_of_all_frames(sweep, order),
                                     left = race(sweep, order, 256).left;
      all += front.size();
      for (const std::size_t point : front)
        lost += !std::binary_search(left.begin(), left.end(), point);
    }
    EXPECT_LT(double(lost), 0.05 * double(all)) << "spread " << spread;
  }
}

INSTANTIATE_TEST_SUITE_P(RacingTest, Races, testing::Values(2, 3));

}  // namespace
}  // namespace racebeam
