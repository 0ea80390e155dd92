// racebeam scene: check, show, plan, new.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

class CliSceneTest : public testing::Test {
 protected:
  ScratchFolder folder;

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  }
};

TEST_F(CliSceneTest, NewWritesASceneThatChecksAndDraws) {
  Program start(folder.path(), {"scene", "new", "a.toml"});
  EXPECT_EQ(start.wait(), 0) << start.err();
  Program check(folder.path(), {"scene", "check", "a.toml"});
  EXPECT_EQ(check.wait(), 0) << check.err();
  EXPECT_THAT(check.out(), StartsWith("good: "));
  EXPECT_THAT(check.out(), HasSubstr(" portals\n"));
  EXPECT_EQ(check.err(), "");
  Program plan(folder.path(), {"scene", "plan", "a.toml", "-o", "a.png"});
  EXPECT_EQ(plan.wait(), 0) << plan.err();
  EXPECT_THAT(read_file(folder / "a.png"), StartsWith("\x89PNG"));
}

TEST_F(CliSceneTest, NewDoesNotOverwrite) {
  write("a.toml", "mine");
  Program program(folder.path(), {"scene", "new", "a.toml"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_EQ(program.err(), "racebeam: a.toml exists; choose another name\n");
  EXPECT_EQ(read_file(folder / "a.toml"), "mine");
}

TEST_F(CliSceneTest, CheckListsAllFaultsOnStderr) {
  write("a.toml", "frames = 0\nplan.storeys = \"@\"\n[camera]\nyew = 1\n");
  for (const char* command : {"check", "show"}) {
    Program program(folder.path(), {"scene", command, "a.toml"});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_EQ(program.out(), "");
    EXPECT_EQ(program.err(),
              "a.toml:1:10: 'frames' is 0\n"
              "  help: it must be in 1..16383: the chip's frame counter has 14 bits\n"
              "a.toml:4:1: unknown key 'yew' in 'camera'\n"
              "  help: did you mean 'yaw'?\n"
              "racebeam: 2 faults in a.toml\n");
  }
}

TEST_F(CliSceneTest, FilesThatCannotBeReadAreRefused) {
  for (const std::string& name : Words{"none.toml", ".", ""}) {
    Program program(folder.path(), {"scene", "check", name});
    EXPECT_EQ(program.wait(), 2) << name;
    EXPECT_EQ(program.out(), "");
  }
}

TEST_F(CliSceneTest, ShowCountsAsTextAndAsJson) {
  write("a.toml",
        "frames = 120\nplan.storeys = \"@.\"\n[[shot]]\nframe = 60\nname = \"the end\"\n");
  Program text(folder.path(), {"scene", "show", "a.toml"});
  EXPECT_EQ(text.wait(), 0);
  for (const char* part :
       {"rooms          2\n", "1, up to 1 in a face", "120 frames (2.0 s), 2 shots",
        "frame 60       the end\n", "room 2, corner 11, camera 1 bits"})
    EXPECT_THAT(text.out(), HasSubstr(part));
  Program json(folder.path(), {"scene", "show", "a.toml", "--json"});
  const nlohmann::json summary = json.json();
  EXPECT_EQ(summary["schema"], "racebeam-scene");
  EXPECT_EQ(summary["rooms"], 2);
  EXPECT_EQ(summary["portals"], 1);
  EXPECT_EQ(summary["timeline"][1], (nlohmann::json{{"frame", 60}, {"name", "the end"}}));
  EXPECT_EQ(summary["deepest_view"], 1);
  EXPECT_GT(summary["worst_line"]["clocks"], 0);
}

TEST_F(CliSceneTest, PlanLeavesNoHalfPicture) {
  write("a.toml", "plan.storeys = \"@.\"\n");
  Program program(folder.path(), {"scene", "plan", "a.toml", "-o", "no/a.png"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("no/a.png"));
  EXPECT_EQ(folder.files(), 1);
}

TEST_F(CliSceneTest, UnknownWordsAreRefusedWithTheNearest) {
  const auto expect = [&](const Words& words, const std::string& part) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr(part));
  };
  expect({"scene"}, "a command is missing; `racebeam scene --help`");
  expect({"scene", "chek", "a"}, "unknown command 'chek'; did you mean 'check'?");
  expect({"scene", "check"}, "file is required; `racebeam scene check --help`");
  expect({"scene", "show", "a", "--jsn"}, "unknown option '--jsn'; did you mean '--json'?");
  expect({"scene", "plan", "a"}, "--output is required");
}

}  // namespace
}  // namespace racebeam
