// The folder of a render: its frames are of one setting, one run at a time writes to it, and its
// manifest tells the truth of all of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

class CliFolderTest : public testing::Test {
 protected:
  ScratchFolder folder;

  Json manifest(const std::string& name = "o") const {
    return read_json(folder / name + "/manifest.json");
  }
  /// Renders into the folder "o"; the exit code is `code`. What it says on stderr.
  std::string render(const Words& more, int code = 0) {
    Words words = {"render", "demo", "-o", "o"};
    words.insert(words.end(), more.begin(), more.end());
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), code) << program.err();
    return program.err();
  }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder / "o"))
      all.insert(entry.path().filename().string());
    return all;
  }
};

TEST_F(CliFolderTest, TheSameSettingsAddFrames) {
  render({"--set", "fifo_entries=12"});
  render({"--set", "fifo_entries=12", "--first", "5", "--frames", "2"});
  render({"--set", "fifo_entries=12", "--first", "6"});
  const Json all = manifest();
  EXPECT_EQ(all["frames"], (Json{0, 5, 6}));
  EXPECT_EQ(all["files"],
            (Json{"frame_0000.png", "stats.json", "frame_0005.png", "frame_0006.png"}));
  EXPECT_EQ(all["earlier_commands"].size(), 2);
  EXPECT_EQ(all["first_frame"], 6) << "of the last run";
  EXPECT_EQ(read_json(folder / "o/stats.json")["total"]["frames"], 1) << "of the last run";
}

TEST_F(CliFolderTest, OtherSettingsAreRefusedWithWhatDiffers) {
  std::ofstream(folder / "a.toml") << "frames = 9\nplan.storeys = \"@.\"\n";
  render({"--set", "fifo_entries=12"});
  const std::string before = read_file(folder / "o/manifest.json");
  const auto refused = [&](const Words& more, const std::string& what) {
    EXPECT_THAT(render(more, 2), AllOf(HasSubstr("o has frames of another render: "),
                                       HasSubstr(what), HasSubstr("--overwrite")));
    EXPECT_EQ(read_file(folder / "o/manifest.json"), before);
  };
  refused({}, "knobs.fifo_entries: 12, now 10");
  refused({"--set", "fifo_entries=12", "--level", "signal"}, "level: tlm, now signal");
  refused({"--set", "fifo_entries=12", "--golden", "trace2"}, "level: tlm, now golden trace2");
  refused({"--set", "fifo_entries=12", "--use", "stacks=lockstep"},
          "units.stacks.implementation: nothing, now lockstep");
  refused({"--set", "fifo_entries=12", "--shake", "7", "--stall", "camera"},
          "channels.camera: nothing, now shake 7,0.05,0.75");
  std::ofstream(folder / "d.toml")
      << "engine = \"beam\"\n[[channel]]\nname = \"interval\"\nfrom = \"subdivider\"\n"
         "to = \"interval_fifo\"\nlatency = 3\ncapacity = 4\n";
  refused({"--set", "fifo_entries=12", "--delays", "d.toml"},
          "channels.interval: nothing, now latency 3, capacity 4");
  Program scene(folder.path(), {"render", "a.toml", "-o", "o", "--set", "fifo_entries=12"});
  EXPECT_EQ(scene.wait(), 2);
  EXPECT_THAT(scene.err(), HasSubstr("scene: demo, now a; scene_hash: built-in, now xxh64 "));
}

TEST_F(CliFolderTest, OverwriteStartsAnew) {
  std::ofstream(folder / "mine.txt") << "mine";
  render({"--frames", "2", "--overlay", "slack"});
  fs::copy(folder / "mine.txt", folder / "o/mine.txt");
  render({"--first", "7", "--set", "dr_bits=9", "--overwrite"});
  EXPECT_EQ(names(),
            (std::set<std::string>{"frame_0007.png", "manifest.json", "mine.txt", "stats.json"}));
  EXPECT_EQ(manifest()["frames"], Json{7});
  EXPECT_EQ(manifest()["earlier_commands"], Json::array());
}

TEST_F(CliFolderTest, TheDefaultFolderMixesNothingEither) {
  Program first(folder.path(), {"render", "demo"});
  EXPECT_EQ(first.wait(), 0);
  Program other(folder.path(), {"render", "demo", "--set", "dr_bits=9"});
  EXPECT_EQ(other.wait(), 2);
  EXPECT_THAT(other.err(), AllOf(HasSubstr("racebeam_out has frames of another render: "),
                                 HasSubstr("knobs.dr_bits: 10, now 9")));
}

TEST_F(CliFolderTest, AStrangersManifestIsNotReplaced) {
  fs::create_directory(folder / "o");
  for (const char* text : {"{}", "[1]", "not JSON", "{\"schema\": \"racebeam-stats\"}"}) {
    std::ofstream(folder / "o/manifest.json") << text;
    EXPECT_THAT(render({}, 2), HasSubstr("o/manifest.json is in the way: it is no manifest"));
    EXPECT_EQ(read_file(folder / "o/manifest.json"), text);
  }
  render({"--overwrite"});
  EXPECT_EQ(manifest()["frames"], Json{0});
}

TEST_F(CliFolderTest, PicturesWithoutAManifestAreNotReplaced) {
  fs::create_directory(folder / "o");
  std::ofstream(folder / "o/frame_0000.png") << "a photograph";
  EXPECT_THAT(render({}, 2), HasSubstr("o has frame_0000.png, but no manifest.json"));
  EXPECT_EQ(read_file(folder / "o/frame_0000.png"), "a photograph");
  render({"--overwrite"});
  EXPECT_EQ(manifest()["frames"], Json{0});
}

// The lock is the one of any process that has the folder open and locked.
TEST_F(CliFolderTest, OneRunAtATimeWritesToAFolder) {
  fs::create_directory(folder / "o");
  const int other = open((folder / "o").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(render({}, 2), HasSubstr("another render writes to o; wait until it ends"));
  EXPECT_TRUE(fs::is_empty(folder / "o"));
  close(other);
  render({});
}

TEST_F(CliFolderTest, AKilledRunFreesTheFolderAndLeavesItsSettings) {
  {
    Program killed(folder.path(),
                   {"render", "demo", "-o", "o", "--frames", "9999", "--set", "dr_bits=9"});
    while (!fs::exists(folder / "o/frame_0000.png") && killed.children() >= 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_THAT(render({}, 2), HasSubstr("another render writes to o"));
    killed.signal(SIGKILL);
    EXPECT_EQ(killed.wait(), -SIGKILL);
  }
  EXPECT_EQ(manifest()["complete"], false);
  EXPECT_THAT(render({}, 2), HasSubstr("knobs.dr_bits: 9, now 10"));
  render({"--set", "dr_bits=9", "--first", "3"});
}

TEST_F(CliFolderTest, TheManifestListsWhatIsWrittenElsewhereToo) {
  render({"--gif", "o/a.gif", "--wav", "b.wav", "--sheet", "c.png", "--stats", "o/stats.json"});
  EXPECT_EQ(manifest()["files"],
            (Json{"frame_0000.png", "stats.json", "a.gif", "../b.wav", "../c.png"}));
}

TEST_F(CliFolderTest, FilesOfRtlAreInTheManifestWithTheirContents) {
  const std::string rtl = RACEBEAM_SOURCE_DIR "/rtl/beam/stacks.sv";
  fs::copy(rtl, folder / "mine.sv");
  render({"--use", "stacks=mine.sv"});
  const Json unit = manifest()["units"]["stacks"];
  EXPECT_EQ(unit["implementation"], "rtl");
  EXPECT_THAT(unit["files"]["mine.sv"].get<std::string>(),
              testing::MatchesRegex("xxh64 [0-9a-f]{16}"));
  std::ofstream(folder / "mine.sv", std::ios::app) << "// more\n";
  EXPECT_THAT(render({"--use", "stacks=mine.sv"}, 2),
              HasSubstr("units.stacks.files.mine.sv: xxh64"));
}

TEST_F(CliFolderTest, ListsOfRtlAreInTheManifestWithAllTheirFiles) {
  fs::create_directory(folder / "a");
  std::ofstream(folder / "a/stacks.sv") << "`include \"more.svh\"\n"
                                        << read_file(RACEBEAM_SOURCE_DIR "/rtl/beam/stacks.sv");
  std::ofstream(folder / "a/more.svh") << "// more\n";
  render({"--use", "stacks=a"});
  EXPECT_TRUE(manifest()["units"]["stacks"]["files"].contains("a/stacks.sv"));
  std::ofstream(folder / "a/more.svh") << "// still more\n";
  EXPECT_THAT(render({"--use", "stacks=a"}, 2), HasSubstr("units.stacks.files.a/more.svh: xxh64"));
}

TEST_F(CliFolderTest, KnobsThatCountForLessAreToldAndWritten) {
  const std::string said =
      render({"--set", "max_room_depth=14", "--set", "face_stack_depth=2", "--stats", "s.json"});
  EXPECT_THAT(said, HasSubstr("max_room_depth=14 counts as 1: a room takes an entry of "
                              "face_stack_depth=2"));
  EXPECT_EQ(manifest()["knobs"]["max_room_depth"], 1);
  EXPECT_EQ(read_json(folder / "s.json")["knobs"]["max_room_depth"], 1);
  Program plain(folder.path(), {"render", "demo", "-o", "p"});
  EXPECT_THAT(plain.err(), Not(HasSubstr("counts as")));
}

TEST_F(CliFolderTest, FramesBeyondTheEndAreTold) {
  EXPECT_THAT(
      render({"--first", "12798", "--frames", "3"}),
      HasSubstr("the show has frames 0..12798 and starts again: the last one is frame 1\n"));
  EXPECT_EQ(manifest()["frames"], (Json{0, 1, 12798}));
}

}  // namespace
}  // namespace racebeam
