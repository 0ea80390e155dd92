// `racebeam explain` as a user runs it: text, JSON, mistakes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string house() { return RACEBEAM_SOURCE_DIR "/scenes/house.toml"; }

TEST(CliExplain, TextTellsColourTimesIntervalWayCostAndSteps) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "1000", "--pixel", "320,240"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const std::string text = program.out();
  EXPECT_THAT(text, StartsWith("pixel      320,240 of frame 1000 of demo: column 320, line 0\n"));
  for (const char* title : {"colour", "shown", "known", "interval", "hit", "depth", "way", "cost"})
    EXPECT_THAT(text, HasSubstr("\n" + std::string(title) + " ")) << title;
  EXPECT_THAT(text, HasSubstr("clock 961 of line 0"));
  EXPECT_THAT(text, HasSubstr("racebeam trace demo --from 1000:0:"));
  EXPECT_THAT(text, HasSubstr("LEFT"));
  EXPECT_THAT(text, HasSubstr("emit"));
  EXPECT_EQ(program.err(), "");
  EXPECT_EQ(folder.files(), 0);
}

TEST(CliExplain, TheExampleOfThePageIsWhatItSays) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "1000", "--pixel", "320,240"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(read_file(RACEBEAM_SOURCE_DIR "/docs/look-inside.md"),
              HasSubstr("```\n" + program.out() + "```"));
}

TEST(CliExplain, JsonStepsAddUpToTheCost) {
  const ScratchFolder folder;
  Program program(folder.path(),
                  {"explain", "demo", "--frame", "7223", "--pixel", "200,100", "--json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json j = program.json();
  EXPECT_EQ(j.at("schema"), "racebeam-explain");
  EXPECT_EQ(j.at("version"), 1);
  EXPECT_EQ(j.at("line"), -140);
  EXPECT_EQ(j.at("pixel"), 199);
  EXPECT_EQ(j.at("shown_clock"), 721);
  const Json& interval = j.at("interval");
  EXPECT_LE(interval.at("first"), j.at("pixel"));
  EXPECT_GE(interval.at("last"), j.at("pixel"));
  int clocks = 0, decisions = 0;
  for (const Json& step : interval.at("steps").elements()) {
    clocks += step.at("clocks").get<int>();
    decisions += step.at("decision").get<bool>();
  }
  EXPECT_EQ(interval.at("cost").at("clocks"), clocks);
  EXPECT_EQ(interval.at("cost").at("decisions"), decisions);
  EXPECT_EQ(interval.at("steps").elements().back().at("clock"), j.at("known_clock"));
  EXPECT_EQ(j.at("slack"), 721 - j.at("known_clock").get<int>());
}

TEST(CliExplain, NamesTheRoomsOfASceneFile) {
  const ScratchFolder folder;
  Program program(folder.path(),
                  {"explain", house(), "--frame", "1500", "--pixel", "320,240", "--json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json way = program.json().at("interval").at("hit").at("way");
  ASSERT_FALSE(way.empty());
  for (const Json& room : way.elements()) EXPECT_FALSE(room.at("name").get<std::string>().empty());
}

TEST(CliExplain, Column0BelongsToTheFifo) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "1000", "--pixel", "0,479"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("column 0 belongs to the FIFO"));
}

TEST(CliExplain, APatternIsTheRayItself) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "2600", "--pixel", "9,9"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("not traced: the ray pattern is shown"));
}

TEST(CliExplain, ALineThatEndsTooSoonIsSaidToBeSo) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "7223", "--pixel", "639,100",
                                  "--set", "clocks_per_pixel=1"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("never: the line ended with an interval on offer"));
  EXPECT_THAT(program.out(), HasSubstr("racebeam trace demo --set clocks_per_pixel=1 --from"));
}

TEST(CliExplain, ALatePixelTellsByHowMuchTheBeamWonAndWhatItShowedInstead) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", "demo", "--frame", "8980", "--pixel", "300,240"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr(" clocks ahead of the tracer"));
  EXPECT_THAT(program.out(), HasSubstr("left over in the FIFO from pixels "));
  EXPECT_THAT(program.out(), HasSubstr("given up in room "));
}

struct Mistake {
  std::vector<std::string> arguments;
  std::string help;
};

TEST(CliExplain, MistakesEndWith2AndSayWhatToDo) {
  const std::vector<Mistake> mistakes = {
      {{"demo", "--frame", "1", "--pixel", "640,0"}, "X is 0..639, Y is 0..479"},
      {{"demo", "--frame", "1", "--pixel", "0,480"}, "X is 0..639, Y is 0..479"},
      {{"demo", "--frame", "1", "--pixel", "0,-1"}, "X is 0..639, Y is 0..479"},
      {{"demo", "--frame", "1", "--pixel", "12"}, "not of the form X,Y"},
      {{"demo", "--frame", "1", "--pixel", "1,2,3"}, "not of the form X,Y"},
      {{"demo", "--frame", "1", "--pixel", "a,b"}, "not of the form X,Y"},
      {{"demo", "--frame", "12799", "--pixel", "1,1"}, "0..12798"},
      {{"demo", "--frame", "-1", "--pixel", "1,1"}, "0..12798"},
      {{"demo", "--frame", "1"}, "--pixel"},
      {{"demo", "--pixel", "1,1"}, "--frame"},
      {{"demoo", "--frame", "1", "--pixel", "1,1"}, "demo"},
      {{"demo", "--frame", "1", "--pixel", "1,1", "--set", "hury_threshold=1"}, "hurry_threshold"},
      {{"demo", "--frame", "1", "--pixel", "1,1", "--set", "corner_bits=14"}, "corner_bits"},
  };
  for (const Mistake& mistake : mistakes) {
    const ScratchFolder folder;
    std::vector<std::string> words = {"explain"};
    words.insert(words.end(), mistake.arguments.begin(), mistake.arguments.end());
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2) << mistake.help;
    EXPECT_THAT(program.err(), HasSubstr(mistake.help));
    EXPECT_EQ(program.out(), "");
  }
}

TEST(CliExplain, AFigureIsDrawnOfAPixelOfAScene) {
  const ScratchFolder folder;
  Program program(folder.path(), {"explain", house(), "--frame", "700", "--pixel", "320,200",
                                  "--figure", "decision-tree", "-o", "tree.svg"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(read_file(folder / "tree.svg"), HasSubstr("frame 700 of house"));
  EXPECT_THAT(program.err(), HasSubstr("wrote tree.svg"));
  EXPECT_EQ(program.out(), "");
}

TEST(CliExplain, FiguresSayWhatTheyNeed) {
  const ScratchFolder folder;
  const std::pair<std::vector<std::string>, const char*> refused[] = {
      {{"--figure", "portl", "-o", "a.svg"}, "did you mean 'portal'?"},
      {{"--figure", "portal"}, "--figure needs -o FILE.svg"},
      {{"--figure", "portal", "-o", "a.png"}, "--figure writes .svg; rename a.png"},
      {{"--figure", "portal", "-o", "a.svg", "--pixel", "0,9"}, "X is 1..639 for a figure"},
      {{"--figure", "portal", "--word", "slack"}, "excludes"},
      {{"demo", "--frame", "9", "--pixel", "9,9", "-o", "a.svg"}, "requires --figure"},
  };
  for (const auto& [words, message] : refused) {
    std::vector<std::string> line = {"explain"};
    line.insert(line.end(), words.begin(), words.end());
    Program program(folder.path(), line);
    EXPECT_EQ(program.wait(), 2) << message;
    EXPECT_THAT(program.err(), HasSubstr(message));
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST(CliExplain, AWordIsExplainedAndAnUnknownOneNamesTheNearest) {
  const ScratchFolder folder;
  Program word(folder.path(), {"explain", "--word", "slack"});
  ASSERT_EQ(word.wait(), 0) << word.err();
  EXPECT_THAT(word.out(), StartsWith("slack   "));
  EXPECT_THAT(word.out(), HasSubstr("the beam won"));
  Program all(folder.path(), {"explain", "--words"});
  ASSERT_EQ(all.wait(), 0) << all.err();
  EXPECT_THAT(all.out(), HasSubstr("\n" + word.out()));
  Program unknown(folder.path(), {"explain", "--word", "slak"});
  EXPECT_EQ(unknown.wait(), 2);
  EXPECT_THAT(unknown.err(), HasSubstr("unknown word 'slak'; did you mean 'slack'?"));
}

TEST(CliExplain, WithoutAPixelItSaysWhatIsMissing) {
  const ScratchFolder folder;
  const std::pair<std::vector<std::string>, const char*> missing[] = {
      {{"explain"}, "a scene is required"},
      {{"explain", "demo"}, "--frame is required"},
      {{"explain", "demo", "--frame", "9"}, "--pixel is required"},
  };
  for (const auto& [words, message] : missing) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr(message));
  }
}

}  // namespace
}  // namespace racebeam
