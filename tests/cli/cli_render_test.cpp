// `racebeam render`: files, statistics, and what is left when a run does not end well.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Names = std::set<std::string>;
namespace fs = std::filesystem;

constexpr int ClocksPerFrame = 840'000;

class CliRenderTest : public testing::Test {
 protected:
  ScratchFolder folder;

  Json parse(const std::string& name) const { return read_json(folder / name); }
  /// All files below the folder, hidden ones too.
  Names names() const {
    Names all;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      if (!entry.is_directory()) all.insert(fs::relative(entry.path(), folder.path()).string());
    return all;
  }
  static std::vector<int> frame_numbers(const Json& stats) {
    std::vector<int> numbers;
    for (const Json& frame : stats.at("frames").elements())
      numbers.push_back(frame.at("frame").get<int>());
    return numbers;
  }
  /// Waits until the file exists; false if it takes too long.
  bool appears(const std::string& name) const {
    for (int i = 0; i < 3000; ++i) {
      if (fs::exists(folder / name)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
};

TEST_F(CliRenderTest, WritesEverythingAskedForAndNothingElse) {
  Program program(folder.path(),
                  {"render", "demo", "--frames", "2", "--first", "60", "-o", "out/a", "--gif",
                   "out/a.gif", "--wav", "a.wav", "--sheet", "a.png", "--stats", "a.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(names(), (Names{"a.json", "a.png", "a.wav", "out/a.gif", "out/a/frame_0060.png",
                            "out/a/frame_0061.png", "out/a/manifest.json", "out/a/stats.json"}));
  EXPECT_EQ(read_file(folder / "a.json"), read_file(folder / "out/a/stats.json"));
  for (const char* png : {"a.png", "out/a/frame_0060.png"})
    EXPECT_EQ(read_file(folder / png).substr(1, 3), "PNG");
  EXPECT_EQ(read_file(folder / "out/a.gif").substr(0, 6), "GIF89a");
  EXPECT_EQ(read_file(folder / "a.wav").substr(0, 4), "RIFF");
  EXPECT_THAT(program.out(), HasSubstr("frame  part"));
  EXPECT_THAT(program.out(), HasSubstr("   61  pillars"));
  EXPECT_THAT(program.out(), HasSubstr("total  2 frames"));
  EXPECT_THAT(program.err(), HasSubstr("wrote 2 frames in out/a, out/a.gif"));
}

TEST_F(CliRenderTest, WithoutOptionsWritesOneFrameToItsOwnFolder) {
  Program program(folder.path(), {"render", "demo"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(names(), (Names{"racebeam_out/frame_0000.png", "racebeam_out/manifest.json",
                            "racebeam_out/stats.json"}));
}

TEST_F(CliRenderTest, ManifestTellsHowThePicturesWereMade) {
  Program program(folder.path(), {"render", "demo", "--first", "700", "--set", "fifo_entries=12",
                                  "--set", "bisection=midpoint", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json manifest = parse("o/manifest.json");
  EXPECT_EQ(manifest.at("version"), RACEBEAM_VERSION);
  EXPECT_EQ(manifest.at("scene"), "demo");
  EXPECT_EQ(manifest.at("scene_hash"), "built-in");
  EXPECT_EQ(manifest.at("knobs").at("fifo_entries"), 12);
  EXPECT_EQ(manifest.at("knobs").at("bisection"), "midpoint");
  EXPECT_EQ(manifest.at("knobs").at("interval_stack_depth"), 4);
  EXPECT_EQ(manifest.at("command")[0], "racebeam");
  EXPECT_EQ(manifest.at("command")[5], "--set");
  EXPECT_EQ(manifest.at("complete"), true);
  EXPECT_EQ(manifest.at("files"), (Json{"frame_0700.png", "stats.json"}));
  const Json stats = parse("o/stats.json");
  EXPECT_EQ(stats.at("knobs"), manifest.at("knobs"));
  EXPECT_EQ(stats.at("frames")[0].at("fifo_fill").size(), 13);
}

// Pictures, counters, checksums and sound; the beam overtakes the tracer in this frame.
TEST_F(CliRenderTest, BothLevelsGiveTheSame) {
  const auto run = [&](const std::string& level) {
    Program program(folder.path(), {"render", "demo", "--first", "7223", "--level", level, "--crc",
                                    "--json", "-o", level, "--wav", level + ".wav"});
    EXPECT_EQ(program.wait(), 0) << program.err();
    Json stats = program.json();
    EXPECT_EQ(stats.at("level"), level);
    EXPECT_EQ(parse(level + "/manifest.json").at("level"), level);
    stats.erase("level");
    return stats;
  };
  EXPECT_EQ(run("tlm"), run("signal"));
  for (const char* file : {"/frame_7223.png", ".wav"})
    EXPECT_TRUE(read_file(folder / (std::string("tlm") + file)) ==
                read_file(folder / (std::string("signal") + file)))
        << file;
}

TEST_F(CliRenderTest, UseNeedsTheWiresOfTheSignalLevel) {
  Program wired(folder.path(), {"render", "demo", "--use", "stacks=lockstep", "--json"});
  ASSERT_EQ(wired.wait(), 0) << wired.err();
  EXPECT_EQ(wired.json().at("level"), "signal");
  Program refused(folder.path(), {"render", "demo", "--level", "tlm", "--use", "stacks=rtl"});
  EXPECT_EQ(refused.wait(), 2);
  EXPECT_THAT(refused.err(), testing::HasSubstr("--level signal"));
}

TEST_F(CliRenderTest, PartsOfALineAddUpToItsClocks) {
  for (const char* level : {"tlm", "signal"}) {
    Program program(folder.path(),
                    {"render", "demo", "--first", "7223", "--level", level, "--stats", "a.json"});
    ASSERT_EQ(program.wait(), 0) << program.err();
    EXPECT_THAT(program.out(), testing::ContainsRegex("\nclocks of a line: camera [0-9.]+, .*, "
                                                      "idle [0-9.]+, in all 1600\n"));
    const Json total = parse("a.json").at("total");
    long all = 0;
    for (const char* part :
         {"camera", "decide", "bisect", "walk", "enter", "return", "wait", "idle"})
      all += total.at("line_" + std::string(part)).at("sum").get<long>();
    EXPECT_EQ(all, 480 * 1600);
    EXPECT_EQ(total.at("line_wait").at("sum"), total.at("fifo_full_stalls"));
    EXPECT_EQ(total.at("line_bisect").at("sum"), total.at("bisection_steps"));
  }
}

TEST_F(CliRenderTest, StatisticsAddUp) {
  Program program(folder.path(), {"render", "demo", "--frames", "2", "--first", "1", "--every",
                                  "2999", "--crc", "--json", "--stats", "a.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json stats = program.json();
  EXPECT_EQ(stats, parse("a.json"));
  EXPECT_EQ(stats.at("schema"), "racebeam-stats");
  EXPECT_EQ(stats.at("version"), 3);
  EXPECT_EQ(stats.at("engine"), "beam");
  EXPECT_EQ(stats.at("level"), "tlm");
  EXPECT_EQ(frame_numbers(stats), (std::vector<int>{1, 3000}));
  const Json& first = stats.at("frames")[0];
  const Json& second = stats.at("frames")[1];
  const Json& total = stats.at("total");
  EXPECT_EQ(first.at("part"), "pillars");
  EXPECT_EQ(second.at("part"), "heights, full ray pattern");
  EXPECT_EQ(first.at("clocks"), ClocksPerFrame);
  EXPECT_EQ(total.at("frames"), 2);
  for (const char* counter :
       {"clocks", "decisions", "left_decisions", "right_decisions", "bisection_steps",
        "adjust_steps", "descents", "pushes", "returns", "return_clocks", "emits", "restarts",
        "starved_pixels", "give_ups", "fifo_full_stalls", "rooms_entered"})
    EXPECT_EQ(total.at(counter), first.at(counter).get<long>() + second.at(counter).get<long>())
        << counter;
  for (const char* histogram : {"fifo_fill", "stack_depth"})
    EXPECT_EQ(total.at(histogram)[0],
              first.at(histogram)[0].get<long>() + second.at(histogram)[0].get<long>());
  // Contract 19.1, frame 1; 19.2 says that full-lock lines are never done.
  EXPECT_EQ(first.at("left_decisions"), 39600);
  EXPECT_EQ(first.at("starved_pixels"), 65);
  EXPECT_EQ(first.at("camera_clocks").at("min"), 47);
  EXPECT_EQ(first.at("done_clock").at("max"), 1086);
  EXPECT_EQ(second.at("done_clock").at("lines_not_done"), 480);
  EXPECT_TRUE(second.at("first_emit_clock").is_null());
  for (const char* crc : {"image_crc32", "pins_crc32"})
    EXPECT_THAT(first.at(crc).get<std::string>(), testing::MatchesRegex("[0-9a-f]{8}"));
}

TEST_F(CliRenderTest, DemoLoops) {
  Program program(folder.path(),
                  {"render", "demo", "--frames", "2", "--first", "12798", "--json", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(frame_numbers(program.json()), (std::vector<int>{12798, 0}));
  EXPECT_EQ(names().count("o/frame_12798.png"), 1);
  EXPECT_EQ(names().count("o/frame_0000.png"), 1);
}

TEST_F(CliRenderTest, AtListsTheFramesInTheirOrder) {
  Program program(folder.path(), {"render", "demo", "--at", "3900,60-62,61,5", "-o", "out",
                                  "--stats", "a.json", "--jobs", "2"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(frame_numbers(parse("a.json")), (std::vector<int>{3900, 60, 61, 62, 5}));
  EXPECT_EQ(parse("out/manifest.json")["frames"], (Json{5, 60, 61, 62, 3900}));
  Program same(folder.path(), {"render", "demo", "--first", "61", "--stats", "b.json"});
  ASSERT_EQ(same.wait(), 0) << same.err();
  EXPECT_EQ(parse("a.json")["frames"][2], parse("b.json")["frames"][0]);
}

TEST_F(CliRenderTest, AtRefusesWhatIsNoListOfFrames) {
  for (const auto& [list, why] : {std::pair{"5,", "'' is no frame"},
                                  {"7-3", "'7-3' is no frame"},
                                  {"x", "'x' is no frame"},
                                  {"5;6", "'5;6' is no frame"},
                                  {"12799", "frames 0..12798"},
                                  {"-1", "frames 0..12798"},
                                  {"99999999999999999999", "out of range"}}) {
    Program program(folder.path(), {"render", "demo", std::string("--at=") + list, "-o", "out"});
    EXPECT_EQ(program.wait(), 2) << list;
    EXPECT_THAT(program.err(), HasSubstr(why)) << list;
  }
  Program both(folder.path(), {"render", "demo", "--at", "5", "--every", "2"});
  EXPECT_EQ(both.wait(), 2);
  EXPECT_THAT(both.err(), HasSubstr("leave out --frames, --first and --every, or --at"));
  EXPECT_EQ(names(), Names{});
}

TEST_F(CliRenderTest, InterruptionKeepsWholeFrames) {
  for (const int number : {SIGINT, SIGTERM}) {
    const std::string out = "out" + std::to_string(number);
    Program program(folder.path(), {"render", "demo", "--frames", "1000", "-o", out, "--gif",
                                    out + "/a.gif", "--wav", out + "/a.wav"});
    ASSERT_TRUE(appears(out + "/frame_0001.png"));
    program.signal(number);
    EXPECT_EQ(program.wait(), 130);
    EXPECT_THAT(program.err(), HasSubstr("stopped early; kept "));
    const Json manifest = parse(out + "/manifest.json");
    const auto frames = parse(out + "/stats.json").at("frames").size();
    EXPECT_GE(frames, 2);
    EXPECT_LT(frames, 1000);
    EXPECT_EQ(manifest.at("complete"), false);
    EXPECT_EQ(manifest.at("frames_rendered"), frames);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / out), {}),
              static_cast<long>(frames + 4));
    EXPECT_EQ(read_file(folder / out + "/a.gif").back(), ';') << "the end of a GIF";
  }
}

TEST_F(CliRenderTest, FullDiskKeepsWholeFramesAndNoHalfFile) {
  Program program(
      folder.path(),
      {"render", "demo", "--frames", "20", "--every", "128", "-o", "o", "--gif", "a.gif"},
      {{}, 20'000, false, {}});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("cannot write "));
  EXPECT_THAT(program.err(), HasSubstr("File too large"));
  const Names left = names();
  EXPECT_EQ(left.count("o/frame_0000.png"), 1);
  EXPECT_EQ(left.count("o/manifest.json"), 1);
  EXPECT_EQ(left.count("o/stats.json"), 1);
  for (const std::string& name : left) {
    if (name.find(".json") != std::string::npos) continue;
    EXPECT_THAT(name, testing::MatchesRegex("o/frame_[0-9]{4}.png"));
    EXPECT_THAT(read_file(folder / name), HasSubstr("IEND")) << name << " is not whole";
  }
}

TEST_F(CliRenderTest, NoOutputOverwritesAnother) {
  for (const auto& [option, path] : std::vector<std::pair<std::string, std::string>>{
           {"--sheet", "o/frame_0000.png"}, {"--stats", "o/manifest.json"}}) {
    Program program(folder.path(), {"render", "demo", "-o", "o", option, path});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr("needs itself; choose another"));
  }
  Program other(folder.path(), {"render", "demo", "--stats", "a.txt"});
  EXPECT_EQ(other.wait(), 2);
  EXPECT_THAT(other.err(), HasSubstr("--stats writes .json; rename a.txt"));
  EXPECT_EQ(names(), Names{});
}

TEST_F(CliRenderTest, RefusedRunLeavesNoFolders) {
  Program program(folder.path(), {"render", "demo", "-o", "n/a/b", "--wav", "none/a.wav"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "n"));
}

TEST_F(CliRenderTest, FullDeviceIsAnError) {
  Program gif(folder.path(), {"render", "demo", "--gif", "/dev/full"});
  EXPECT_EQ(gif.wait(), 2);
  EXPECT_THAT(gif.err(), HasSubstr("cannot write /dev/full: No space left"));
  Program table(folder.path(), {"render", "demo", "--gif", "a.gif"},
                {"/dev/full", RLIM_INFINITY, false, {}});
  EXPECT_EQ(table.wait(), 2);
  EXPECT_THAT(table.err(), HasSubstr("standard output"));
  EXPECT_EQ(names(), Names{});
}

TEST_F(CliRenderTest, ProgressIsShownOnATerminalOnly) {
  const std::vector<std::string> words = {"render", "demo", "--stats", "a.json"};
  Program seen(folder.path(), words, {{}, RLIM_INFINITY, true, {}});
  ASSERT_EQ(seen.wait(), 0);
  EXPECT_THAT(seen.err(), HasSubstr("0/1 frames"));
  EXPECT_THAT(seen.err(), testing::ContainsRegex("1/1 frames  [0-9.]+ M clocks/s  0:00 left"));
  EXPECT_THAT(seen.out(), Not(HasSubstr("\x1b")));
  Program quiet(folder.path(), words);
  EXPECT_EQ(quiet.err(), "racebeam: wrote 1 frame, a.json\n");
  Program unwatched(folder.path(), words, {{}, RLIM_INFINITY, true, "CI=true"});
  EXPECT_EQ(unwatched.err(), "racebeam: wrote 1 frame, a.json\r\n");
}

}  // namespace
}  // namespace racebeam
