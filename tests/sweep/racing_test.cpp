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

TEST(RacingTest, RungsDoubleUpToTheSample) {
  EXPECT_THAT(rungs(256), ElementsAre(16, 32, 64, 128, 256));
  EXPECT_THAT(rungs(100), ElementsAre(16, 32, 64, 100));
  EXPECT_THAT(rungs(17), ElementsAre(16, 17));
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
/// point and, at random, by frame. The more cells, the less, roughly.
class KnownSweep {
 public:
  KnownSweep(const std::vector<double>& truth, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return double(random() >> 8) / double(1 << 24); };
    for (int point = 0; point < 40; ++point) {
      const double size = uniform(), luck = uniform();
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
  for (std::size_t point = 0; point < sweep.size(); ++point) race.left.push_back(point);
  int before = 0;
  for (const int rung : rungs(sample)) {
    race.frames += double(race.left.size()) * (rung - before) / (double(sweep.size()) * sample);
    before = rung;
    std::vector<Candidate> points;
    for (const std::size_t point : race.left) points.push_back(sweep.candidate(point, order, rung));
    const std::vector<Stop> stopped =
        stops(points, Goals, rung, for_best_of(static_cast<int>(sweep.size()) - 1));
    for (auto stop = stopped.rbegin(); stop != stopped.rend(); ++stop)
      race.left.erase(race.left.begin() + static_cast<std::ptrdiff_t>(stop->point));
  }
  return race;
}

class Races : public testing::TestWithParam<std::size_t> {
 protected:
  Races() : figure_(demo_frames().figures[GetParam()]), order_(indices_of(figure_)) {}

  static std::vector<int> indices_of(const std::vector<double>& figure) {
    std::vector<int> indices(figure.size());
    std::iota(indices.begin(), indices.end(), 0);
    return frame_order(indices, 1);
  }

  const std::vector<double> figure_;
  const std::vector<int> order_;
};

TEST_P(Races, LoseNoPointOfTheFrontAndSaveFrames) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const KnownSweep sweep(figure_, seed);
    const std::vector<std::size_t> front = front_of_all_frames(sweep, order_);
    EXPECT_GE(front.size(), 3);
    const Race raced = race(sweep, order_, 256);
    EXPECT_THAT(raced.left, IsSupersetOf(front));
    EXPECT_LT(raced.left.size(), sweep.size());
    EXPECT_LT(raced.frames, 0.8);
  }
}

INSTANTIATE_TEST_SUITE_P(RacingTest, Races, testing::Values(2, 3));

}  // namespace
}  // namespace racebeam
