// The sphere tracer looked at as a user does: beside double precision, pixel by pixel, live.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

std::string scene(const std::string& name) {
  return RACEBEAM_SOURCE_DIR "/scenes/sphere/" + name + ".toml";
}

TEST(CliSphereLook, GoldenCompareCountsDifferingPixels) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", scene("bounce"), "--frames", "2", "--jobs", "2",
                                  "--golden", "compare", "--stats", "stats.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("not as golden"));
  EXPECT_THAT(program.out(), HasSubstr("\nRMSE "));
  const Json stats = read_json(folder / "stats.json");
  const Json total = stats.at("total").at("golden");
  EXPECT_EQ(total.at("pixels"), 2 * 320 * 240);
  EXPECT_EQ(total.at("levels"), 31);
  for (const char* name : {"differing_pixels", "by_more_than_one_level", "wrong_first_hits"}) {
    int sum = 0;
    for (const Json& picture : stats.at("pictures").elements())
      sum += picture.at("golden").at(name).get<int>();
    EXPECT_EQ(total.at(name), sum) << name;
  }
  EXPECT_GT(total.at("differing_pixels"), 0);
  EXPECT_GT(total.at("psnr"), 20);
}

TEST(CliSphereLook, GoldenPictureIsAlmostTheChips) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", scene("inside"), "--golden", "geometry", "-o",
                                  "golden.png", "--stats", "golden.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json stats = read_json(folder / "golden.json");
  EXPECT_EQ(stats.at("schema"), "racebeam-golden");
  EXPECT_EQ(stats.at("tracer"), "geometry");
  Program other(folder.path(), {"render", scene("inside"), "--golden", "trace4"});
  EXPECT_EQ(other.wait(), 2);
  EXPECT_THAT(other.err(), HasSubstr("geometry"));
}

TEST(CliSphereLook, ExplainTellsStatesAndClocksOfAPixel) {
  const ScratchFolder folder;
  const std::vector<std::string> words = {"explain", scene("four"), "--frame",
                                          "0",       "--pixel",     "256,190"};
  Program program(folder.path(), words);
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), testing::StartsWith("pixel      256,190 of picture 0 of four\n"));
  EXPECT_THAT(program.out(), HasSubstr("word 18df"));
  EXPECT_THAT(program.out(), HasSubstr("188 clocks"));
  EXPECT_THAT(program.out(), HasSubstr(" REFLECT "));
  std::vector<std::string> json = words;
  json.emplace_back("--json");
  Program as_json(folder.path(), json);
  ASSERT_EQ(as_json.wait(), 0) << as_json.err();
  EXPECT_EQ(as_json.json().at("clocks"), 188);
  Program outside(folder.path(), {"explain", scene("four"), "--frame", "0", "--pixel", "512,0"});
  EXPECT_EQ(outside.wait(), 2);
  EXPECT_THAT(outside.err(), HasSubstr("X is 0..511, Y is 0..479"));
}

TEST(CliSphereLook, ViewShowsPicturesInTheTerminalAndTakesTheBoardsKeys) {
  const ScratchFolder folder;
  Program program(folder.path(),
                  {"view", scene("bounce"), "--term", "--frames", "3", "--keys", "t u 7 u a o h"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("SW17..SW0"));
  EXPECT_THAT(program.out(), HasSubstr("100000000000000100"));
  EXPECT_THAT(program.err(), HasSubstr("wrote view_000"));
  Program wrong(folder.path(), {"view", scene("bounce"), "--term", "--level", "signal"});
  EXPECT_EQ(wrong.wait(), 2);
  EXPECT_THAT(wrong.err(), HasSubstr("--level tlm"));
}

}  // namespace
}  // namespace racebeam
