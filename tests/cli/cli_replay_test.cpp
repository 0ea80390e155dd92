// `racebeam capture` and `racebeam verify --replay` through the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "tb/base/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

constexpr long long FrameClocks = 840000;
const std::string File = "stacks.traffic";

class CliReplayTest : public testing::Test {
 protected:
  void capture(Words words) const {
    words.insert(words.begin(), "capture");
    words.insert(words.end(), {"-o", File});
    Program run(folder.path(), words);
    ASSERT_EQ(run.wait(), 0) << run.err();
  }
  void expect_refused(const Words& words, const std::string& said) const {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(said));
  }
  /// The only unit of a run that ends with `code`.
  Json unit(Words words, int code) const {
    words.emplace_back("--json");
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    return run.json()["units"][0];
  }
  /// stacks with the mistake of exhibit 19 of the museum.
  std::string mistaken() const {
    std::string text = read_file(rtl_file("stacks"));
    const std::string from = "(n + 1) % IntervalStackDepth";
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    std::ofstream(folder / "mine.sv") << text.replace(at, from.size(), "n % IntervalStackDepth");
    return "stacks=mine.sv";
  }
  std::string part(const std::string& name) const {
    return folder / ("racebeam_verify/stacks/" + name);
  }

  ScratchFolder folder;
};

TEST_F(CliReplayTest, RtlAndModelSayWhatTheModelSaid) {
  capture({"stacks", "--random", "5000"});
  for (const char* word : {"stacks", "stacks=model"}) {
    const Json row = unit({"verify", word, "--replay", File}, 0);
    EXPECT_EQ(row["clocks"], 5000);
    EXPECT_EQ(row["differences"], 0);
    EXPECT_EQ(row["traffic"], "replay");
  }
}

TEST_F(CliReplayTest, AMistakeIsFoundWhereLockstepFindsItInTheChip) {
  capture({"stacks", "--frames", "2"});
  const std::string mine = mistaken();
  const Json replayed = unit({"verify", mine, "--replay", File}, 1)["first"];
  const Json chip = unit({"verify", mine, "--frames", "2", "--random", "0"}, 1)["first"];
  for (const char* key : {"port", "clock", "expected", "got"})
    EXPECT_EQ(replayed[key], chip[key]) << key;
  for (const char* key : {"frame", "line", "clock"})
    EXPECT_EQ(replayed["place"][key], chip["place"][key]) << key;
}

TEST_F(CliReplayTest, AMistakeIsFoundWhereLockstepFindsItAlone) {
  capture({"stacks", "--random", "5000"});
  const std::string mine = mistaken();
  const Json replayed = unit({"verify", mine, "--replay", File}, 1)["first"];
  const Json alone = unit({"verify", mine, "--frames", "0", "--random", "5000"}, 1)["first"];
  for (const char* key : {"port", "clock", "expected", "got"})
    EXPECT_EQ(replayed[key], alone[key]) << key;
}

TEST_F(CliReplayTest, TrafficOfSomethingElseIsRefused) {
  capture({"stacks", "--random", "100"});
  expect_refused({"verify", "interval_fifo", "--replay", File},
                 "is traffic of stacks, not of interval_fifo");
  expect_refused({"verify", "stacks", "--replay", File, "--set", "interval_stack_depth=2"},
                 "say --set interval_stack_depth=4");
  expect_refused({"verify", "stacks", "--replay", File, "--scene", "house"}, "the scene demo");
  expect_refused({"verify", "stacks", "scene", "--replay", File}, "name the one");
  expect_refused({"verify", "stacks", "--replay", File, "--frames", "1"}, "leave out --frames");
  expect_refused({"verify", "stacks", "--replay", "nothing"}, "cannot read nothing");
  std::filesystem::resize_file(folder / File, 400);
  expect_refused({"verify", "stacks", "--replay", File}, "racebeam capture");
}

TEST_F(CliReplayTest, CapturesThatCannotBeAreRefused) {
  expect_refused({"capture", "racebeam_top", "-o", File}, "capture one of its units");
  expect_refused({"capture", "stack", "-o", File}, "stacks");
  expect_refused({"capture", "stacks", "--first", "12799", "-o", File}, "out of range");
  expect_refused({"capture", "stacks", "--walk", "-o", File}, "stacks has no walk");
  expect_refused({"capture", "stacks", "-o", "no/such/folder/file"}, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(folder / File));
}

TEST_F(CliReplayTest, AKilledReplayGoesOnWithThePartsThatAreDone) {
  const Words words = {"verify", "stacks", "--replay", "all", "--first", "0", "--frames", "8"};
  {
    Program run(folder.path(), words);
    while (!std::filesystem::exists(part("frames_00000_1.json")) && run.runs())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait(), -SIGKILL);
  }
  ASSERT_FALSE(std::filesystem::exists(part("frames_00007_1.json")));
  const auto written = std::filesystem::last_write_time(part("frames_00000_1.json"));
  const Json row = unit(words, 0);
  EXPECT_EQ(row["clocks"], 8 * (FrameClocks + 1));
  EXPECT_EQ(row["differences"], 0);
  EXPECT_EQ(std::filesystem::last_write_time(part("frames_00000_1.json")), written);
}

TEST_F(CliReplayTest, GatesOfManyPartsAreReplayedAtOnceAndAMistakeIsFound) {
  const Words frames = {"--replay", "all", "--first", "0", "--frames", "9"};
  const auto words = [&](const std::string& unit) {
    Words all = {"verify", unit};
    all.insert(all.end(), frames.begin(), frames.end());
    return all;
  };
  const Json good = unit(words("stacks=gates"), 0);
  EXPECT_EQ(good["clocks"], 9 * (FrameClocks + 1));
  EXPECT_EQ(good["differences"], 0);
  const std::string mine = mistaken(), file = mine.substr(mine.find('=') + 1);
  const Json rtl = unit(words(mine), 1)["first"];
  const Json gates = unit(words("stacks=gates:" + file), 1)["first"];
  for (const char* key : {"port", "clock", "expected", "got"})
    EXPECT_EQ(gates[key], rtl[key]) << key;
}

TEST_F(CliReplayTest, ADamagedPartIsComparedAgain) {
  const Words words = {"verify", "stacks", "--replay", "all", "--frames", "2"};
  EXPECT_EQ(unit(words, 0)["clocks"], 2 * (FrameClocks + 1));
  const std::string path = part("frames_09598_1.json");  // of 12,799, at three quarters
  std::string text = read_file(path);
  text[text.find("840001") + 1] = '5';
  std::ofstream(path) << text;
  Program again(folder.path(), words);
  EXPECT_EQ(again.wait(), 0);
  EXPECT_THAT(again.err(), HasSubstr("frames_09598_1.json is damaged"));
  EXPECT_THAT(read_file(path), HasSubstr("840001"));
}

TEST_F(CliReplayTest, PartsOfOtherRtlAreNotMixed) {
  Program run(folder.path(), {"verify", "stacks", "--replay", "all", "--frames", "1"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  expect_refused({"verify", mistaken(), "--replay", "all", "--frames", "1"}, "with another RTL");
  const Json row = unit(
      {"verify", mistaken(), "--replay", "all", "--first", "0", "--frames", "1", "-o", "mine"}, 1);
  EXPECT_EQ(row["first"]["place"]["frame"], 0);
  EXPECT_THAT(row["first"]["text"].get<std::string>(),
              HasSubstr("repeat: racebeam capture stacks --first 0 --frames 1 --scene demo -o "
                        "stacks.traffic && racebeam verify stacks=mine.sv --replay stacks.traffic "
                        "--scene demo\n"));
}

TEST_F(CliReplayTest, UnitsThatShareAPassSayWhatTheySayAlone) {
  Program run(folder.path(), {"verify", "interval_fifo", mistaken(), "navigator", "sequencer",
                              "--replay", "all", "--first", "0", "--frames", "2", "--json"});
  EXPECT_EQ(run.wait(), 1) << run.err();
  const Json rows = run.json()["units"];
  ASSERT_EQ(rows.size(), 4u);
  for (const int n : {0, 2, 3}) {
    EXPECT_EQ(rows[n]["clocks"], 2 * (FrameClocks + 1)) << rows[n].dump();
    EXPECT_EQ(rows[n]["differences"], 0) << rows[n].dump();
  }
  const Json alone = unit({"verify", "stacks=mine.sv", "--replay", "all", "--first", "0",
                           "--frames", "2", "-o", "alone"},
                          1);
  EXPECT_EQ(rows[1]["differences"], alone["differences"]);
  for (const char* key : {"port", "clock", "expected", "got", "place"})
    EXPECT_EQ(rows[1]["first"][key], alone["first"][key]) << key;
}

TEST_F(CliReplayTest, RtlThatEndsLeavesTheOthersOfItsPassAlone) {
  std::string text = read_file(rtl_file("stacks"));
  text.insert(text.rfind("endmodule"), "always_ff @(posedge clk_i) if (push_en_i) $finish;\n");
  std::ofstream(folder / "ends.sv") << text;
  Program run(folder.path(), {"verify", "interval_fifo", "stacks=ends.sv", "--replay", "all",
                              "--frames", "1", "--json"});
  EXPECT_EQ(run.wait(), 2);
  const Json rows = run.json()["units"];
  EXPECT_EQ(rows[0]["clocks"], FrameClocks + 1);
  EXPECT_TRUE(rows[0]["fault"].is_null());
  EXPECT_THAT(rows[1]["fault"].get<std::string>(), HasSubstr("ends.sv"));
}

TEST_F(CliReplayTest, TheWholeChipBeginsInAnyFrame) {
  const Json row = unit({"verify", "racebeam_top", "--replay", "all", "--frames", "3"}, 0);
  EXPECT_EQ(row["clocks"], 3 * (FrameClocks + 1));
  EXPECT_EQ(row["differences"], 0);
  expect_refused({"verify", "racebeam_top=model", "--replay", "all"}, "back doors");
}

TEST_F(CliReplayTest, ARecordHasARowForEachUnitAndLevel) {
  const Words words = {"verify",   "stacks", "stacks=gates", "--replay", "all",
                       "--frames", "1",      "--record",     "kept.json"};
  for (int time = 0; time < 2; ++time) {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 0) << run.err();
    const Json rows = Json::parse(read_file(folder / "kept.json"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["level"], "rtl");
    EXPECT_EQ(rows[1]["level"], "gates");
    EXPECT_EQ(rows[1]["clocks"], FrameClocks + 1);
    EXPECT_NE(rows[0]["rtl"], rows[1]["rtl"]);
    EXPECT_EQ(rows[0]["model"], rows[1]["model"]);
    EXPECT_EQ(rows[1]["command"],
              "racebeam verify stacks=gates --scene demo --replay all --frames 1");
  }
  Program range(folder.path(), {"verify", "stacks", "--replay", "all", "--first", "12798",
                                "--record", "kept.json"});
  EXPECT_EQ(range.wait(), 0) << range.err();
  const Json rows = Json::parse(read_file(folder / "kept.json"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[2]["command"],
            "racebeam verify stacks --scene demo --replay all --first 12798 --frames 1");
  std::ofstream(folder / "kept.json") << "words";
  expect_refused(words, "kept.json holds no record of replays");
  expect_refused({"verify", "stacks", "--record", "kept.json"}, "of --replay all");
}

TEST_F(CliReplayTest, FramesThatTheSceneDoesNotHaveAreRefused) {
  expect_refused({"verify", "stacks", "--replay", "all", "--frames", "12800"},
                 "--frames 12800 is out of range; the scene has 12799");
  expect_refused({"verify", "stacks", "--replay", "all", "--first", "12798", "--frames", "2"},
                 "--first 12798 --frames 2 is out of range; the scene has 12799");
  expect_refused({"verify", "stacks", "--replay", "all", "--first", "12799"}, "is out of range");
  expect_refused({"verify", "stacks", "--first", "3"}, "of --replay all");
}

TEST_F(CliReplayTest, TwoReplaysAtOnceAreRefused) {
  const Words words = {"verify", "stacks", "--replay", "all", "--frames", "600"};
  Program first(folder.path(), words);
  while (!std::filesystem::exists(part("replay.txt")) && first.runs())
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  expect_refused(words, "another replay is at work there");
  first.signal(SIGINT);
  EXPECT_EQ(first.wait(), 130);
  EXPECT_EQ(first.children(), 0);
}

}  // namespace
}  // namespace racebeam
