// A plan gives all work out once, in blocks of about the same time, and what workers answer is
// taken if it is of this plan, whole and asked for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/rung_plan.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

#include "tb/base/errors.h"
#include "tb/sweep/block_results.h"
#include "tb/sweep/row_digest.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

PlannedWork work_of(int point, std::vector<int> frames, int scene = 0) {
  PlannedWork work;
  work.work.point = point;
  work.work.scene = scene;
  work.work.scene_name = "demo";
  work.work.scene_hash = "hash of the scene";
  work.work.frames = std::move(frames);
  work.setting = "hash of point " + std::to_string(point);
  return work;
}

std::vector<PlannedWork> points_of(int points, int frames) {
  std::vector<int> all(static_cast<std::size_t>(frames));
  std::iota(all.begin(), all.end(), 0);
  std::vector<PlannedWork> work;
  for (int point = 0; point < points; ++point) work.push_back(work_of(point, all));
  return work;
}

double second(const Block&) { return 1; }

Answer answer_of(int number, int frame) {
  Answer answer;
  answer.block = number;
  answer.frame.row = {frame, false, 0, {frame * 7}};
  answer.frame.row.digest = frame_digest(frame, answer.frame.row.values);
  return answer;
}

class RungPlanTest : public testing::Test {
 protected:
  RungPlan planned(const std::vector<PlannedWork>& work, int blocks) const {
    RungPlan plan{1, "model", divided(work, blocks, second)};
    keep_rung(folder.path(), plan);
    return plan;
  }
  std::string result(const std::string& name) const { return folder / ("results/" + name); }

  /// Frames that are taken, by number of their work; `refused` is what is not.
  std::map<int, std::vector<int>> read(const RungPlan& plan) {
    ResultReader reader(folder.path(), plan);
    std::map<int, std::vector<int>> frames;
    reader.read([&](int, const PlannedWork& work, AnswerLine line) {
      frames[work.work.number].push_back(line.answer.frame.row.frame);
    });
    refused = reader.refused();
    return frames;
  }

  ScratchFolder folder;
  std::string refused;
};

TEST_F(RungPlanTest, EveryFrameOfEveryPointIsInOneBlock) {
  for (const int blocks : {1, 3, 7, 100, 5000}) {
    std::set<std::pair<int, int>> there;
    std::set<int> numbers;
    for (const auto& block : divided(points_of(5, 300), blocks, second))
      for (const PlannedWork& one : block) {
        EXPECT_TRUE(numbers.insert(one.work.number).second);
        for (const int frame : one.work.frames)
          EXPECT_TRUE(there.insert({one.work.point, frame}).second) << "twice";
      }
    EXPECT_EQ(there.size(), 5u * 300) << blocks;
  }
}

TEST_F(RungPlanTest, AreAsManyBlocksAsAskedForWhereFramesAreEqual) {
  EXPECT_EQ(divided(points_of(5, 300), 100, second).size(), 100u);
  EXPECT_EQ(divided(points_of(7, 11), 3, second).size(), 3u);
  EXPECT_EQ(divided(points_of(2, 3), 100, second).size(), 6u) << "no frame is cut";
}

TEST_F(RungPlanTest, BlocksTakeTheSameTimeWhereScenesDoNot) {
  std::vector<PlannedWork> work = points_of(4, 100);
  for (int point = 0; point < 4; ++point) work.push_back(work_of(point, {0, 1, 2, 3, 4}, 1));
  const auto cost = [](const Block& one) { return one.scene == 0 ? 0.1 : 2.0; };
  const auto blocks = divided(work, 8, cost);  // of 40 + 40 seconds
  ASSERT_LE(blocks.size(), 8u);
  for (const auto& block : blocks) {
    double seconds = 0;
    for (const PlannedWork& one : block) seconds += double(one.work.frames.size()) * cost(one.work);
    EXPECT_LT(seconds, 10 + 2.0 + 1e-6);
  }
}

TEST_F(RungPlanTest, PointsOnTheSameFramesShareABlock) {
  const auto blocks = divided(points_of(4, 256), 4, [](const Block&) { return 0.01; });
  ASSERT_EQ(blocks.size(), 4u);
  for (const auto& block : blocks) {
    std::set<int> points, frames;
    for (const PlannedWork& one : block) {
      points.insert(one.work.point);
      frames.insert(one.work.frames.begin(), one.work.frames.end());
    }
    EXPECT_EQ(points.size(), 4u);
    EXPECT_EQ(frames.size(), 64u) << "whose pictures are made once";
  }
}

TEST_F(RungPlanTest, AFileIsReadAsItWasWritten) {
  PlannedWork one = work_of(3, {5, 9});
  one.work.guard = one.work.causes = true;
  const RungPlan plan = planned({one}, 1), read = load_rung(folder.path(), 1);
  EXPECT_EQ(read.model, "model");
  EXPECT_EQ(read.hash, plan.hash);
  ASSERT_EQ(read.blocks.size(), 1u);
  const PlannedWork& again = read.blocks[0][0];
  EXPECT_EQ(again.setting, "hash of point 3");
  EXPECT_THAT(again.work.frames, ElementsAre(5, 9));
  EXPECT_TRUE(again.work.guard && again.work.causes && !again.work.scan);
  EXPECT_EQ(again.work.scene_hash, "hash of the scene");
}

TEST_F(RungPlanTest, AFolderThatIsNotSeenHereSaysSo) {
  try {
    load_rung(folder.path(), 1);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("plan/1.json is not there"), HasSubstr("--on slurm")));
  }
  planned(points_of(1, 1), 1);
  std::ofstream(folder / "plan/2.json") << "{\"schema\": \"something\"}";
  EXPECT_THROW(load_rung(folder.path(), 2), UsageError);
}

TEST_F(RungPlanTest, TwoWorkersOfABlockHaveTwoFiles) {
  const RungPlan plan = planned(points_of(1, 3), 1);
  ResultFile first(folder.path(), plan, 0), second(folder.path(), plan, 0);
  second.append(answer_line(answer_of(1, 2)));
  first.append(answer_line(answer_of(1, 0)) + answer_line(answer_of(1, 1)));
  EXPECT_TRUE(fs::exists(result("1.0.0.jsonl")) && fs::exists(result("1.0.1.jsonl")));
  EXPECT_THAT(read(plan)[1], testing::UnorderedElementsAre(0, 1, 2));
  EXPECT_EQ(refused, "");
}

TEST_F(RungPlanTest, ATornLastLineIsNoneUntilItEnds) {
  const RungPlan plan = planned(points_of(1, 3), 1);
  ResultFile(folder.path(), plan, 0)
      .append(answer_line(answer_of(1, 0)) + answer_line(answer_of(1, 1)));
  const std::string whole = result("1.0.0.jsonl");
  std::ifstream in(whole);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::size_t line = text.find('\n') + 1;
  for (const std::size_t cut : {line + 1, line + 40, text.size() - 1}) {
    std::ofstream(whole) << text.substr(0, cut);
    EXPECT_THAT(read(plan)[1], ElementsAre(0)) << cut << " of " << text.size();
    EXPECT_EQ(refused, "");
  }
  ResultReader reader(folder.path(), plan);
  std::vector<int> frames;
  const auto take = [&](int, const PlannedWork&, AnswerLine answer) {
    frames.push_back(answer.answer.frame.row.frame);
  };
  reader.read(take);
  EXPECT_THAT(frames, ElementsAre(0));
  std::ofstream(whole, std::ios::app) << '\n';
  reader.read(take);
  EXPECT_THAT(frames, ElementsAre(0, 1));
}

TEST_F(RungPlanTest, LinesOfAnotherPlanAreRefusedAndNamed) {
  const RungPlan plan = planned(points_of(1, 3), 1);
  RungPlan other{1, "another model", plan.blocks, "0123456789abcdef"};
  ResultFile(folder.path(), other, 0).append(answer_line(answer_of(1, 0)));
  ResultFile(folder.path(), plan, 0).append(answer_line(answer_of(1, 1)));
  EXPECT_THAT(read(plan)[1], ElementsAre(1));
  EXPECT_THAT(refused, HasSubstr("results/1.0.0.jsonl: 1 line refused: of another model or sweep, "
                                 "0123456789abcdef; this plan is " +
                                 plan.hash));
}

TEST_F(RungPlanTest, ADigitThatHasChangedIsDamage) {
  const RungPlan plan = planned(points_of(1, 3), 1);
  std::string line = answer_line(answer_of(1, 1));
  const auto digit = line.find("\"values\":\"") + 10;
  line[digit] = line[digit] == '7' ? '8' : '7';
  ResultFile(folder.path(), plan, 0).append(answer_line(answer_of(1, 0)) + line);
  EXPECT_THAT(read(plan)[1], ElementsAre(0));
  EXPECT_EQ(refused, "results/1.0.0.jsonl: 1 line refused: damaged\n");
}

TEST_F(RungPlanTest, AFrameThatNobodyHasAskedForIsRefused) {
  const RungPlan plan = planned(points_of(1, 3), 1);
  ResultFile(folder.path(), plan, 0)
      .append(answer_line(answer_of(1, 3)) + answer_line(answer_of(2, 0)));
  EXPECT_TRUE(read(plan).empty());
  EXPECT_THAT(refused, HasSubstr("2 lines refused: the plan asks this block for no such frame"));
}

}  // namespace
}  // namespace racebeam
