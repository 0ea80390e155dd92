// Pixels of the block renderer, explained: the vectors of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/block_explanation.h"

#include <gtest/gtest.h>

#include <array>
#include <tuple>

#include "tests/support/json.h"

namespace racebeam {
namespace {

Json explained(int column, int row) {
  RunOptions options;
  options.scene = RACEBEAM_SOURCE_DIR "/scenes/block/quad.toml";
  const racebeam::Run run = open_run(options);
  return Json::parse(block_explain_json(run, {0, column, row}, ""));
}

TEST(BlockExplanation, StatesAddUpToThePixelsClocks) {
  for (const auto& [column, row, clocks, rgb] : {std::tuple{320, 240, 48, std::array{47, 139, 93}},
                                                 {360, 80, 49, {129, 129, 44}},
                                                 {300, 180, 48, {80, 202, 141}}}) {
    const Json json = explained(column, row);
    EXPECT_EQ(json.at("clocks"), clocks);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(json.at("rgb").elements()[n], rgb[n]);
    int sum = 0;
    for (const auto& step : json.at("steps").elements()) {
      EXPECT_EQ(step.at("clock"), sum);
      sum += step.at("clocks").get<int>();
    }
    EXPECT_EQ(sum, clocks);
  }
}

TEST(BlockExplanation, TellsTheBlockItsCoreAndWhenItWasDealt) {
  const Json json = explained(320, 240);
  EXPECT_EQ(json.at("block"), 15 * 40 + 20);
  EXPECT_EQ(json.at("first_hit"), "sphere 0");
  EXPECT_LT(json.at("core").get<int>(), 4);
  EXPECT_GT(json.at("begin").get<int>(), json.at("dealt").get<int>());
}

TEST(BlockExplanation, APixelOfABlockThatIsClearedHasNoRay) {
  const Json json = explained(3, 3);
  EXPECT_EQ(json.at("cleared"), true);
  EXPECT_EQ(json.at("clocks"), 0);
  EXPECT_EQ(json.at("first_hit"), "nothing");
  EXPECT_EQ(json.at("block"), 0);
  EXPECT_EQ(json.at("dealt"), 0);
}

}  // namespace
}  // namespace racebeam
