// Pixels of the voxel tracer, explained: the vectors of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/voxel_explanation.h"

#include <gtest/gtest.h>

#include "tests/support/json.h"

namespace racebeam {
namespace {

Json explained(int column, int row, const std::vector<std::string>& set = {}) {
  RunOptions options;
  options.scene = RACEBEAM_SOURCE_DIR "/scenes/voxel/tiny.toml";
  options.assignments = set;
  const racebeam::Run run = open_run(options);
  return Json::parse(voxel_explain_json(run, {0, column, row}, ""));
}

void expect_sum(const Json& json) {
  int sum = 0;
  for (const auto& state : json.at("states").elements()) sum += state.at("clocks").get<int>();
  EXPECT_EQ(json.at("clocks"), sum);
}

TEST(VoxelExplanation, StatesAddUpToThePixelsClocks) {
  for (const int column : {0, 13, 32, 63})
    for (const int row : {0, 20, 47}) {
      expect_sum(explained(column, row));
      expect_sum(explained(column, row, {"shadows=on", "shading=slope", "memory_clocks=3"}));
      expect_sum(explained(column, row, {"group_fetch=on", "max_outer=3"}));
    }
}

TEST(VoxelExplanation, TellsTheRayOfTheVectors) {
  const Json json = explained(32, 24);
  EXPECT_EQ(json.at("end"), "hit");
  EXPECT_EQ(json.at("direction").elements()[1], 39321);
  EXPECT_EQ(json.at("direction").elements()[2], -22938);
  EXPECT_EQ(json.at("position").elements()[0].get<int>() >> 8, 32);
  EXPECT_EQ(json.at("position").elements()[1].get<int>() >> 8, 54);
  EXPECT_NEAR(json.at("position").elements()[2].get<int>() / 256.0, 9.7070, 0.0001);
  const auto steps = json.at("steps").elements();
  EXPECT_EQ(steps.front().at("level"), 4);
  EXPECT_EQ(steps.back().at("outcome"), "hit");
}

TEST(VoxelExplanation, TellsWhatStoppedARay) {
  EXPECT_EQ(explained(32, 24, {"max_outer=1"}).at("end"), "stopped by max_outer");
}

}  // namespace
}  // namespace racebeam
