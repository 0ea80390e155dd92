// racebeam scene: check, show, plan, new, notes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;
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
  const Json summary = json.json();
  EXPECT_EQ(summary["schema"], "racebeam-scene");
  EXPECT_EQ(summary["rooms"], 2);
  EXPECT_EQ(summary["portals"], 1);
  EXPECT_EQ(summary["timeline"][1], (Json{{"frame", 60}, {"name", "the end"}}));
  EXPECT_EQ(summary["deepest_view"], 1);
  EXPECT_GT(summary["worst_line"]["clocks"], 0);
}

TEST_F(CliSceneTest, ShowEstimatesWithTheKnobsSet) {
  write("a.toml", "frames = 60\nplan.storeys = \"@....\\n.#.#.\\n.....\"\n");
  const auto show = [&](const Words& more) {
    Words words = {"scene", "show", "a.toml", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.json();
  };
  const Json plain = show({});
  const Json shallow = show({"--set", "interval_stack_depth=1", "--set", "clocks_per_pixel=3"});
  EXPECT_EQ(plain["knobs"]["interval_stack_depth"], 4);
  EXPECT_EQ(shallow["knobs"]["interval_stack_depth"], 1);
  EXPECT_EQ(plain["worst_line"]["budget"], 1530);
  EXPECT_EQ(shallow["worst_line"]["budget"], 2330);
  EXPECT_GT(shallow["worst_line"]["clocks"], plain["worst_line"]["clocks"]);
  EXPECT_EQ(show({"--set", "corner_bits=13"})["corner_bits"], 13);
  for (const char* command : {"show", "check"}) {
    Program refused(folder.path(), {"scene", command, "a.toml", "--set", "interval_stack_dept=1"});
    EXPECT_EQ(refused.wait(), 2) << command;
    EXPECT_EQ(refused.out(), "");
  }
}

TEST_F(CliSceneTest, CheckWarnsOfWhatIsAllowedButHardlyMeant) {
  write("a.toml",
        "frames = 9\n[plan]\nstoreys = \"@#.\"\n[plan.cells]\nL = { height = 64 }\n"
        "[camera]\nyaw = { start = 90 }\npitch = -45\n");
  Program program(folder.path(), {"scene", "check", "a.toml"});
  EXPECT_EQ(program.wait(), 0);
  EXPECT_EQ(program.out(), "good: 2 rooms, 0 portals\n");
  EXPECT_EQ(program.err(),
            "a.toml:3:14: warning: nothing leads to '1.1.3'\n"
            "  help: join it to a room by a portal, set the camera down in it by a [[shot]], or "
            "leave it out\n"
            "a.toml:5:1: warning: no cell of the plan is 'L'\n"
            "  help: draw one, or leave out the kind\n"
            "a.toml:7:17: warning: 'yaw' is 90 of 2048: that is 16 degrees\n"
            "  help: 90 degrees are 512\n"
            "a.toml:8:9: warning: 'pitch' is -45 of 2048: that is -8 degrees\n"
            "  help: -45 degrees are -256\n");
}

TEST_F(CliSceneTest, OurOwnScenesHaveNoWarnings) {
  for (const char* sub :
       {"/scenes", "/scenes/chip", "/scenes/sphere", "/scenes/block", "/scenes/common"})
    for (const auto& entry : fs::directory_iterator(std::string(RACEBEAM_SOURCE_DIR) + sub)) {
      if (entry.path().extension() != ".toml") continue;
      Program program(folder.path(), {"scene", "check", entry.path().string()});
      EXPECT_EQ(program.wait(), 0);
      EXPECT_EQ(program.err(), "");
    }
}

TEST_F(CliSceneTest, PlanWritesWhatItsNameSays) {
  write("a.toml", "name = \"my hall\"\nplan.storeys = \"@.\"\n");
  for (const auto& [name, begins] :
       {std::pair{"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"b.PNG", "\x89PNG"}}) {
    Program program(folder.path(), {"scene", "plan", "a.toml", "-o", name});
    EXPECT_EQ(program.wait(), 0) << program.err();
    EXPECT_THAT(program.err(), HasSubstr("wrote " + std::string(name)));
    EXPECT_THAT(read_file(folder / name), StartsWith(begins));
  }
  EXPECT_THAT(read_file(folder / "a.svg"), HasSubstr("<svg "));
  for (const char* name : {"a.jpg", "a", "a.svg.txt"}) {
    Program program(folder.path(), {"scene", "plan", "a.toml", "-o", name});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr("scene plan writes .png or .svg; rename "));
  }
}

TEST_F(CliSceneTest, PlanLeavesNoHalfPicture) {
  write("a.toml", "plan.storeys = \"@.\"\n");
  Program program(folder.path(), {"scene", "plan", "a.toml", "-o", "no/a.png"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("no/a.png"));
  EXPECT_EQ(folder.files(), 1);
}

TEST_F(CliSceneTest, NotesJudgeScenesAndTheDemo) {
  write("a.toml", "frames = 60\nplan.storeys = \"@.\"\n[camera]\nvelocity = [3, 0, 0]\n");
  fs::create_directory(folder / "sub");
  write("sub/b|c.toml", "name = \"b|c #\"\nplan.storeys = \"@\"\n");
  const auto notes = [&](const Words& of, const std::string& file, const std::string& said) {
    Words all = {"scene", "notes", "-o", file};
    all.insert(all.end(), of.begin(), of.end());
    Program program(folder.path(), all);
    EXPECT_EQ(program.wait(), 0) << program.err();
    EXPECT_EQ(program.out(), "");
    EXPECT_EQ(program.err(), "racebeam: wrote " + file + ": " + said + "\n");
    return read_file(folder / file);
  };
  const std::string text =
      notes({"a.toml", "sub/b|c.toml", "demo", "--frames", "2"}, "n.md", "6 frames of 3 scenes");
  EXPECT_THAT(text, StartsWith("<!-- made by `racebeam scene notes`, do not edit -->\n"));
  for (const std::string& part :
       {std::string("racebeam " RACEBEAM_VERSION
                    ": `racebeam scene notes a.toml b|c.toml demo --frames 2`"),
        std::string(
            "\n## a\n\n2 rooms, 1 portals, at most 1 in a face; 60 frames, 1.0 s; the camera "
            "passes portals: 1 east, 0 west, 0 down, 0 up, 0 north, 0 south; 11 corner bits; "
            "deepest view 1 portals.\n\nFrames 15, 45.\n"),
        std::string("\n## b\\|c \\#\n"), std::string("\n## demo\n\nThe built-in demo"),
        std::string("Frames 3199 (ray pattern), 9599.\n"), std::string("| `multiplier_cut` | "),
        std::string("limits switched off: 0 pixels differ from `trace4`.\n")})
    EXPECT_THAT(text, HasSubstr(part));
  const Words one = {"a.toml", "--frames", "1"};
  EXPECT_EQ(notes(one, "n.md", "1 frames of 1 scene"),
            notes(one, "sub/again.md", "1 frames of 1 scene"))
      << "the same input gives the same file";
}

// The counters of the notes are those of the wired chip.
TEST_F(CliSceneTest, NotesCountWhatRenderCounts) {
  Program chip(folder.path(), {"render", "demo", "--first", "6399", "--json", "--golden", "compare",
                               "--stats", "s.json"});
  const Json total = chip.json()["total"];
  Program program(folder.path(), {"scene", "notes", "demo", "--frames", "1", "-o", "n.md"});
  EXPECT_EQ(program.wait(), 0) << program.err();
  const std::string text = read_file(folder / "n.md");
  const auto count = [](const Json& value) { return std::to_string(value.get<int>()); };
  for (const char* counter : {"restarts", "starved_pixels", "give_ups"})
    EXPECT_THAT(text, HasSubstr(" in a frame | " + count(total[counter]) + ".0 | " +
                                count(total[counter]) + " | "));
  EXPECT_THAT(text, HasSubstr(" | " + count(total["busy_clocks"]["max"]) + " | frame 6399, y " +
                              count(total["busy_clocks"]["worst_line"])));
  const Json& golden = total["golden"];
  for (const auto& [cause, pixels] : golden["causes"].items())
    EXPECT_THAT(text, HasSubstr("| `" + cause + "` | " + count(pixels) + " | "));
  for (const auto& [tracer, pixels] : golden["differing_pixels"].items())
    EXPECT_THAT(text, HasSubstr("| **chip, `" + tracer + "`** | " + count(pixels) + " | "));
}

TEST_F(CliSceneTest, NotesAreOfTheKnobsSet) {
  Program chip(folder.path(), {"render", "demo", "--first", "6399", "--json", "--stats", "s.json",
                               "--set", "interval_stack_depth=2"});
  const Json total = chip.json()["total"];
  Program program(folder.path(), {"scene", "notes", "demo", "--set", "interval_stack_depth=2",
                                  "--frames", "1", "-o", "n.md"});
  EXPECT_EQ(program.wait(), 0) << program.err();
  const std::string text = read_file(folder / "n.md");
  EXPECT_THAT(text, HasSubstr("`racebeam scene notes demo --set interval_stack_depth=2 "
                              "--frames 1`\n"));
  EXPECT_THAT(text, HasSubstr("with its own knobs but those set here."));
  const std::string restarts = total["restarts"].dump();
  EXPECT_THAT(text, HasSubstr("| restarts in a frame | " + restarts + ".0 | " + restarts + " | "));
  EXPECT_THAT(text, HasSubstr("limits switched off: 0 pixels differ from `trace4`.\n"));
  Program refused(folder.path(),
                  {"scene", "notes", "demo", "--set", "stack_depth=2", "-o", "no.md"});
  EXPECT_EQ(refused.wait(), 2);
  EXPECT_THAT(refused.err(), HasSubstr("stack_depth"));
  EXPECT_FALSE(fs::exists(folder / "no.md"));
}

TEST_F(CliSceneTest, NotesOfAFaultySceneAreNotWritten) {
  write("a.toml", "frames = 0\nplan.storeys = \"@\"\n");
  Program faulty(folder.path(), {"scene", "notes", "demo", "a.toml", "-o", "n.md"});
  EXPECT_EQ(faulty.wait(), 2);
  EXPECT_THAT(faulty.err(), HasSubstr("a.toml:1:10: 'frames' is 0"));
  Program lost(folder.path(), {"scene", "notes", "demo", "-o", "no/n.md"});
  EXPECT_EQ(lost.wait(), 2);
  EXPECT_THAT(lost.err(), HasSubstr("no/n.md"));
  EXPECT_EQ(folder.files(), 1);
}

TEST_F(CliSceneTest, InterruptedNotesAreNotWritten) {
  Program::Setting terminal;
  terminal.terminal = true;
  Program program(folder.path(), {"scene", "notes", "demo", "-o", "n.md"}, terminal);
  program.wait_for("/12 frames");
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130);
  EXPECT_THAT(program.err(), HasSubstr("stopped early"));
  EXPECT_EQ(folder.files(), 0);
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
  expect({"scene", "notes", "demo"}, "--output is required");
  expect({"scene", "notes", "-o", "n.md"}, "scene is required");
  expect({"scene", "notes", "demmo", "-o", "n.md"}, "did you mean 'demo'?");
  expect({"scene", "notes", "demo", "-o", "n.md", "--frames", "0"}, "--frames");
}

}  // namespace
}  // namespace racebeam
