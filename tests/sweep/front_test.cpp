// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/front.h"

#include <gtest/gtest.h>

#include <numeric>

namespace racebeam {
namespace {

constexpr int Population = 1'000;

Reading exact(double value) { return {Reading::Exact, value, {}}; }

Reading sampled(std::vector<double> values, int population = Population,
                Reading::Kind kind = Reading::Sampled) {
  Stratum stratum;
  stratum.frames.resize(values.size());
  std::iota(stratum.frames.begin(), stratum.frames.end(), 0);
  stratum.values = std::move(values);
  stratum.population = population;
  return {kind, 0, {stratum}};
}

/// 16 frames about `mean`, of any point in the same way, but for `wiggle` up and down.
Reading about(double mean, double wiggle = 0, int population = Population) {
  std::vector<double> values;
  for (int i = 0; i < 16; ++i) values.push_back(mean + i + (i % 2 == 0 ? wiggle : -wiggle));
  return sampled(values, population);
}

Reading all_about(double mean) { return about(mean, 0, 16); }

std::vector<Verdict> judged(const std::vector<Goal>& goals,
                            const std::vector<std::vector<Reading>>& points) {
  std::vector<Candidate> candidates;
  for (const std::vector<Reading>& readings : points)
    candidates.push_back({"p" + std::to_string(candidates.size()), readings});
  return judge(candidates, goals, Confidence);
}

void expect(const Verdict& verdict, Verdict::Standing standing, int by = -1) {
  EXPECT_EQ(verdict.standing, standing);
  EXPECT_EQ(verdict.by, by);
}

const std::vector<Goal> ErrorAndCells = {{"picture_error", GoalKind::Min},
                                         {"cells", GoalKind::Min}};

TEST(FrontTest, TradesAreAllOnTheFront) {
  for (const Verdict& verdict :
       judged(ErrorAndCells, {{about(3), exact(7)}, {about(2), exact(8)}, {about(4), exact(6)}}))
    expect(verdict, Verdict::Front);
}

TEST(FrontTest, SurelyWorseAtNoLessCellsIsDominated) {
  const auto verdicts =
      judged(ErrorAndCells, {{about(3), exact(7)}, {about(3.5), exact(7)}, {about(3.5), exact(8)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Dominated, 0);
  expect(verdicts[2], Verdict::Dominated, 0);
}

TEST(FrontTest, WorseInTheMeanAloneIsUndecided) {
  const auto verdicts = judged(ErrorAndCells, {{about(3), exact(7)}, {about(3.01, 5), exact(7)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Undecided);
}

TEST(FrontTest, FramesInCommonDecideWhatMeansWouldNot) {
  // The means' own intervals are +/- 0.37, and overlap; each frame is worse by 0.1.
  const Reading a = about(3), b = about(3.1);
  EXPECT_GT(mean_of(a.frames).high(), mean_of(b.frames).low());
  expect(judged(ErrorAndCells, {{a, exact(7)}, {b, exact(7)}})[1], Verdict::Dominated, 0);
}

TEST(FrontTest, AlikeInTheFramesTakenIsNotAlike) {
  const auto verdicts = judged(ErrorAndCells, {{about(3), exact(7)}, {about(3), exact(8)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Undecided);
  expect(judged(ErrorAndCells, {{all_about(3), exact(7)}, {all_about(3), exact(8)}})[1],
         Verdict::Dominated, 0);
}

TEST(FrontTest, EqualPointsDoNotDominateEachOther) {
  for (const Verdict& verdict :
       judged(ErrorAndCells, {{all_about(3), exact(7)}, {all_about(3), exact(7)}}))
    expect(verdict, Verdict::Front);
}

TEST(FrontTest, MustBeBetterInEverySampledGoal) {
  const std::vector<Goal> goals = {{"picture_error", GoalKind::Min}, {"starved", GoalKind::Min}};
  const auto verdicts =
      judged(goals, {{about(3), about(9)}, {about(4), about(1)}, {about(5), about(10)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Front);
  EXPECT_EQ(verdicts[2].standing, Verdict::Dominated);
}

TEST(FrontTest, MoreMayBeBetter) {
  const std::vector<Goal> goals = {{"first_emit", GoalKind::Max}, {"cells", GoalKind::Min}};
  const auto verdicts = judged(goals, {{about(200), exact(7)}, {about(220), exact(7)}});
  expect(verdicts[0], Verdict::Dominated, 1);
  expect(verdicts[1], Verdict::Front);
}

TEST(FrontTest, ExactGoalsAloneNeedNoFrames) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min}, {"flip_flops", GoalKind::Min}};
  const auto verdicts =
      judged(goals, {{exact(7), exact(4)}, {exact(7), exact(5)}, {exact(6), exact(9)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Dominated, 0);
  expect(verdicts[2], Verdict::Front);
}

TEST(FrontTest, BeyondALimitIsUnwanted) {
  const std::vector<Goal> goals = {{"picture_error", GoalKind::Min},
                                   {"starved", GoalKind::Limit, {}, 20}};
  // The means are 7.5 above what is named, +/- 0.37.
  const auto verdicts = judged(
      goals,
      {{about(1), about(14)}, {about(3), about(12.7)}, {about(4), about(2)}, {about(9), about(2)}});
  expect(verdicts[0], Verdict::Unwanted, 1);
  expect(verdicts[1], Verdict::Undecided);  // 20.2 +/- 0.37
  expect(verdicts[2], Verdict::Front);
  expect(verdicts[3], Verdict::Dominated, 2);
}

TEST(FrontTest, LeastIsALimitFromBelow) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min}, {"first_emit", GoalKind::Limit, 20}};
  const auto verdicts = judged(goals, {{exact(6), about(2)}, {exact(7), about(22)}});
  expect(verdicts[0], Verdict::Unwanted, 1);
  expect(verdicts[1], Verdict::Front);
}

TEST(FrontTest, AGoalMayHaveLimitsOnBothSides) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min, 5, 7}};
  const auto verdicts = judged(goals, {{exact(4)}, {exact(5)}, {exact(7)}, {exact(8)}});
  expect(verdicts[0], Verdict::Unwanted, 0);
  expect(verdicts[1], Verdict::Front);
  expect(verdicts[2], Verdict::Dominated, 1);
  expect(verdicts[3], Verdict::Unwanted, 0);
}

TEST(FrontTest, DominatingTakesMoreThanAChanceToBeWithinTheLimit) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min}, {"starved", GoalKind::Limit, {}, 20}};
  // 19.8 +/- 0.37 may be beyond it; so it dominates only what starves surely more than itself.
  const auto verdicts =
      judged(goals, {{exact(6), about(12.3)}, {exact(7), about(2)}, {exact(7), about(12.4)}});
  expect(verdicts[0], Verdict::Front);
  expect(verdicts[1], Verdict::Undecided);
  EXPECT_EQ(verdicts[2].standing, Verdict::Dominated);
}

TEST(FrontTest, WorstCasesAreSureOnlyOfAllFrames) {
  const std::vector<Goal> goals = {{"busy.max", GoalKind::Min}, {"cells", GoalKind::Min}};
  const auto largest = [](double value, int population) {
    return sampled({1, value, 2}, population, Reading::Largest);
  };
  expect(judged(goals, {{largest(7, 3), exact(1)}, {largest(8, 3), exact(1)}})[1],
         Verdict::Dominated, 0);
  expect(judged(goals, {{largest(7, 9), exact(1)}, {largest(8, 9), exact(1)}})[1],
         Verdict::Undecided);
}

TEST(FrontTest, WorstCaseSeenIsEnoughToBeBeyondALimit) {
  const std::vector<Goal> goals = {{"busy.max", GoalKind::Limit, {}, 1'500}};
  expect(judged(goals, {{sampled({1'400, 1'534}, 9, Reading::Largest)}})[0], Verdict::Unwanted, 0);
  expect(judged(goals, {{sampled({1'400, 1'434}, 9, Reading::Largest)}})[0], Verdict::Front);
}

TEST(FrontTest, WorstCaseSeenIsNotSurelyWithinALimit) {
  const std::vector<Goal> goals = {{"cells", GoalKind::Min},
                                   {"busy.max", GoalKind::Limit, {}, 1'500}};
  const auto judged_of = [&](int population) {
    return judged(goals, {{exact(6), sampled({1'400, 1'410}, population, Reading::Largest)},
                          {exact(7), sampled({1'300, 1'310}, population, Reading::Largest)}});
  };
  expect(judged_of(9)[1], Verdict::Undecided);
  expect(judged_of(2)[1], Verdict::Dominated, 0);
}

TEST(FrontTest, PointsWithoutCommonFramesAreNotCompared) {
  Reading other = about(9);
  for (int& frame : other.frames[0].frames) frame += 500;
  for (const Verdict& verdict : judged(ErrorAndCells, {{about(3), exact(7)}, {other, exact(7)}}))
    expect(verdict, Verdict::Front);
}

TEST(FrontTest, NoPointsHaveNoFront) { EXPECT_TRUE(judge({}, ErrorAndCells, Confidence).empty()); }

}  // namespace
}  // namespace racebeam
