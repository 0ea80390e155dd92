// Promises of tb/sweep/front_search.h and nsga2_library.h, on goals that are known of every point.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/front_search.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "tb/base/errors.h"

namespace racebeam {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::Gt;
using testing::Lt;

const std::string Knobs =
    "[goals]\npicture_error = \"min\"\ndecisions = \"min\"\n"
    "[knobs]\ninterval_stack_depth = { from = 1, to = 16 }\nbisection = [\"pow2\", \"midpoint\"]\n"
    "fifo_entries = { from = 3, to = 34 }\ndr_bits = { from = 8, to = 13 }\n"
    "skip_shared_edges = \"on\"\nhurry_threshold = { from = 0, to = 90, step = 6 }\n";

std::string searched(int seed, int population = 16, int generations = 12) {
  return "search = { method = \"nsga2\", population = " + std::to_string(population) +
         ", generations = " + std::to_string(generations) + ", seed = " + std::to_string(seed) +
         " }\n";
}

Reading exact(double value) { return {Reading::Exact, value, {}}; }

using Known = std::function<std::pair<double, double>(const SweepPoint&)>;

int value_of(const SweepPoint& point, const char* knob) { return point.k.of(knob); }

// Two goals that cannot both be had: few entries, or short distances from a best setting.
std::pair<double, double> two_goals(const SweepPoint& point) {
  const double stack = value_of(point, "interval_stack_depth"),
               fifo = value_of(point, "fifo_entries"), bits = value_of(point, "dr_bits"),
               hurry = value_of(point, "hurry_threshold");
  const double error = 20 / stack + 40 / fifo + 4 * (13 - bits) + (hurry - 48) * (hurry - 48) / 200;
  const double size = 17 * stack + 8 * fifo + 12 * bits + (value_of(point, "bisection") ? 90 : 0);
  return {error, size};
}

struct Outcome {
  std::vector<std::string> names;       ///< of points, as they were planned
  std::map<std::string, int> measured;  ///< how often, by name
  SweepPlan plan;
};

// Searches; the `stop`th time that points are to be measured ends it.
Outcome search(const std::string& text, const Known& known, int stop = -1,
               std::map<std::string, std::vector<Reading>>* kept = nullptr) {
  Outcome outcome{{}, {}, plan_sweep_text(text, "s")};
  SweepPlan& plan = outcome.plan;
  std::size_t before = 0;
  std::map<std::string, std::vector<Reading>> own;
  auto& store = kept ? *kept : own;
  const SearchOwner owner = {
      [&] {
        if (stop-- == 0) throw Interrupted();
        for (; before < plan.points.size(); ++before) {
          const SweepPoint& point = plan.points[before].point;
          outcome.names.push_back(point.name);
          const std::string key = plan.points[before].settings.front();
          if (store.count(key)) continue;
          ++outcome.measured[point.name];
          const auto [error, size] = known(point);
          store[key] = {exact(error), exact(size)};
        }
      },
      [&](int point) { return store.at(plan.points[std::size_t(point)].settings.front()); }};
  try {
    search_front(plan, owner);
  } catch (const Interrupted&) {
  }
  return outcome;
}

std::vector<std::string> settings(const SweepPlan& plan) {
  std::vector<std::string> all;
  for (const PlannedPoint& point : plan.points)
    all.push_back(point.point.name + "\n" + point.settings.front());
  return all;
}

// The area that the points dominate, up to (`error`, `size`).
double hypervolume(const std::vector<PlannedPoint>& points, double error, double size) {
  std::vector<std::pair<double, double>> goals;
  for (const PlannedPoint& point : points) goals.push_back(two_goals(point.point));
  std::sort(goals.begin(), goals.end());
  double area = 0, lowest = size;
  for (const auto& [x, y] : goals) {
    if (x >= error || y >= lowest) continue;
    area += (error - x) * (lowest - y);
    lowest = y;
  }
  return area;
}

TEST(FrontSearchTest, BeginsWithThePointsOfSobol) {
  const SweepPlan plan = plan_sweep_text(searched(5) + Knobs, "s"),
                  sobol = plan_sweep_text(
                      "search = { method = \"sobol\", points = 16, seed = 5 }\n" + Knobs, "s");
  EXPECT_EQ(settings(plan), settings(sobol));
  EXPECT_EQ(plan.first.size(), 16u);
}

TEST(FrontSearchTest, AsksForTheSameWhenItIsAnsweredTheSame) {
  const Outcome one = search(searched(1) + Knobs, two_goals),
                other = search(searched(1) + Knobs, two_goals);
  EXPECT_GT(one.plan.points.size(), 100u) << "of 208 that it asks for";
  EXPECT_EQ(settings(one.plan), settings(other.plan));
  EXPECT_NE(settings(one.plan), settings(search(searched(2) + Knobs, two_goals).plan));
}

TEST(FrontSearchTest, StoppedInAnyGenerationItGoesOnWithTheSamePoints) {
  const Outcome whole = search(searched(3) + Knobs, two_goals);
  for (int stop = 0; stop <= 12; ++stop) {
    std::map<std::string, std::vector<Reading>> kept;
    const Outcome cut = search(searched(3) + Knobs, two_goals, stop, &kept);
    EXPECT_LT(cut.names.size(), whole.names.size());
    const Outcome rest = search(searched(3) + Knobs, two_goals, -1, &kept);
    EXPECT_EQ(settings(rest.plan), settings(whole.plan)) << "stopped in generation " << stop;
    for (const auto& [name, times] : cut.measured)
      EXPECT_EQ(rest.measured.count(name), 0u) << name << " is there";
    EXPECT_EQ(cut.measured.size() + rest.measured.size(), whole.measured.size());
  }
}

TEST(FrontSearchTest, NoPointIsPlannedTwice) {
  const Outcome outcome = search(searched(4) + Knobs, two_goals);
  std::set<std::string> different;
  for (const PlannedPoint& point : outcome.plan.points) different.insert(point.settings.front());
  EXPECT_EQ(different.size(), outcome.plan.points.size());
}

TEST(FrontSearchTest, ItsFrontIsBetterThanSobolsWithAsManyPoints) {
  for (int seed = 1; seed <= 5; ++seed) {
    const Outcome outcome = search(searched(seed) + Knobs, two_goals);
    const SweepPlan sobol = plan_sweep_text("search = { method = \"sobol\", points = " +
                                                std::to_string(outcome.plan.points.size() - 1) +
                                                ", seed = " + std::to_string(seed) + " }\n" + Knobs,
                                            "s");
    ASSERT_EQ(sobol.points.size(), outcome.plan.points.size());
    EXPECT_GT(hypervolume(outcome.plan.points, 60, 600), hypervolume(sobol.points, 60, 600));
  }
}

TEST(FrontSearchTest, WhatWhereRefusesIsNotPlanned) {
  std::string text = searched(1) + Knobs;
  text += "where = \"interval_stack_depth * 17 + fifo_entries * 8 <= 200\"\n";
  const Outcome outcome = search(text, two_goals);
  EXPECT_GT(outcome.plan.points.size(), 60u);
  for (const PlannedPoint& point : outcome.plan.points)
    EXPECT_LE(value_of(point.point, "interval_stack_depth") * 17 +
                  value_of(point.point, "fifo_entries") * 8,
              200);
}

TEST(FrontSearchTest, ItGoesOnWherePointsFailAndAvoidsThem) {
  SweepPlan plan = plan_sweep_text(searched(1, 32, 12) + Knobs, "s");
  const auto fails = [&](std::size_t point) {
    return value_of(plan.points[point].point, "fifo_entries") < 12;
  };
  search_front(plan, {[] {},
                      [&](int point) -> std::vector<Reading> {
                        if (fails(std::size_t(point))) return {};
                        const auto [error, size] = two_goals(plan.points[std::size_t(point)].point);
                        return {exact(error), exact(size)};
                      }});
  const auto share = [&](std::size_t begin, std::size_t end) {
    int count = 0;
    for (std::size_t point = begin; point < end; ++point) count += fails(point);
    return double(count) / double(end - begin);
  };
  const std::size_t half = plan.points.size() / 2;
  EXPECT_GT(half, 100u);
  EXPECT_LT(share(half, plan.points.size()), share(1, 33));
}

TEST(FrontSearchTest, OwnersErrorEndsItAndIsTheirs) {
  SweepPlan plan = plan_sweep_text(searched(1) + Knobs, "s");
  const auto full = [] { throw std::runtime_error("the disk is full"); };
  EXPECT_THROW(search_front(plan, {full, {}}), std::runtime_error);
}

TEST(SearchGoalsTest, AreTheFiguresOfMinAndMax) {
  const std::vector<Goal> goals = {{"busy", GoalKind::Min, {}, {}},
                                   {"starved", GoalKind::Limit, {}, 2.0},
                                   {"slack.p1", GoalKind::Max, {}, {}}};
  EXPECT_THAT(search_goals(goals, {exact(700), exact(1), exact(30)}), ElementsAre(700, -30));
  const Stratum frames{{1, 2, 3}, {4, 9, 5}, 100};
  EXPECT_THAT(
      search_goals(goals,
                   {{Reading::Sampled, 0, {frames}}, exact(0), {Reading::Largest, 0, {frames}}}),
      ElementsAre(6, -9));
}

TEST(SearchGoalsTest, ALimitMayBeReachedAndWhatIsBeyondIsTheWorseTheFurther) {
  const std::vector<Goal> goals = {{"busy", GoalKind::Min, {}, {}},
                                   {"starved", GoalKind::Limit, {}, 2.0},
                                   {"slack.p1", GoalKind::Max, 10.0, {}}};
  EXPECT_THAT(search_goals(goals, {exact(700), exact(2), exact(10)}), ElementsAre(700, -10));
  const std::vector<double> near = search_goals(goals, {exact(1), exact(3), exact(99)}),
                            far = search_goals(goals, {exact(1), exact(3), exact(9)}),
                            failed = search_goals(goals, {});
  EXPECT_THAT(near, Each(Gt(1e30)));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(near[i], far[i]);
    EXPECT_LT(far[i], failed[i]);
  }
  const std::vector<double> endless =
      search_goals({{"busy", GoalKind::Min, {}, 1e-300}}, {exact(1e300)});
  EXPECT_LT(endless[0], failed[0]);
}

}  // namespace
}  // namespace racebeam
