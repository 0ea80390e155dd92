// The program with scenes of the sphere tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string scene(const std::string& name) {
  return RACEBEAM_SOURCE_DIR "/scenes/sphere/" + name + ".toml";
}

class CliSphereTest : public testing::Test {
 protected:
  /// What it says on stdout.
  std::string run(const std::vector<std::string>& words) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.out();
  }
  /// What it says on stderr.
  std::string refused(const std::vector<std::string>& words) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2) << program.err();
    EXPECT_EQ(program.out(), "");
    return program.err();
  }

  ScratchFolder folder;
};

TEST_F(CliSphereTest, RendersAPictureWithItsCounters) {
  run({"render", "sphere/four", "-o", "four.png", "--stats", "four.json"});
  EXPECT_THAT(read_file(folder / "four.png"), StartsWith("\x89PNG"));
  const Json stats = read_json(folder / "four.json");
  EXPECT_EQ(stats.at("version"), 3);
  EXPECT_EQ(stats.at("engine"), "sphere");
  EXPECT_EQ(stats.at("knobs").at("write_policy"), "sync");
  const Json& picture = stats.at("pictures").at(0);
  EXPECT_EQ(picture.at("picture"), 0);
  EXPECT_EQ(picture.at("clocks"), 79822445);
  EXPECT_EQ(picture.at("frames"), 190);
  EXPECT_EQ(picture.at("counters").at("overflows"), 24469);
  EXPECT_EQ(picture.at("counters").at("buffer_fill").size(), 65U);
  EXPECT_EQ(picture.at("per_pixel").at("clocks").get<double>(), 324.798);
}

TEST_F(CliSphereTest, SeveralProcessesLeaveTheFilesOfOne) {
  for (const char* jobs : {"1", "2"})
    run({"render", scene("bounce"), "--first", "590", "--frames", "20", "--crc", "-o", jobs,
         "--gif", std::string(jobs) + ".gif", "--sheet", std::string(jobs) + ".png", "--jobs",
         jobs});
  for (const char* file : {"/stats.json", "/frame_0591.png", "/frame_0009.png", ".gif", ".png"})
    EXPECT_TRUE(read_file(folder / (std::string("1") + file)) ==
                read_file(folder / (std::string("2") + file)))
        << file;
}

TEST_F(CliSphereTest, BothLevelsLeaveTheSameButForTheirName) {
  std::string stats[2];
  for (const int level : {0, 1}) {
    run({"render", scene("inside"), "--crc", "--level", level ? "signal" : "tlm", "--stats",
         "s.json"});
    Json json = read_json(folder / "s.json");
    EXPECT_EQ(json.at("level"), level ? "signal" : "tlm");
    json.erase("level");
    stats[level] = json.dump();
    std::filesystem::remove(folder / "s.json");
  }
  EXPECT_EQ(stats[0], stats[1]);
}

TEST_F(CliSphereTest, KnobsAreTheEnginesAndMayBeSet) {
  EXPECT_THAT(run({"knobs", "--engine", "sphere"}), HasSubstr("root_bits_per_clock"));
  const Json slow = Json::parse(run({"render", scene("inside"), "--first", "23", "--set",
                                     "root_bits_per_clock=1", "-o", "a.png", "--json"}));
  const Json own =
      Json::parse(run({"render", scene("inside"), "--first", "23", "-o", "b.png", "--json"}));
  EXPECT_EQ(slow.at("knobs").at("root_bits_per_clock"), 1);
  EXPECT_GT(slow.at("pictures").at(0).at("clocks"), own.at("pictures").at(0).at("clocks"));
  EXPECT_TRUE(read_file(folder / "a.png") == read_file(folder / "b.png"));
  EXPECT_THAT(refused({"render", scene("inside"), "--set", "dr_bits=9"}),
              HasSubstr("knob dr_bits is one of beam"));
  EXPECT_THAT(refused({"render", "demo", "--set", "divide_clocks=9"}),
              HasSubstr("knob divide_clocks is one of sphere"));
  EXPECT_THAT(refused({"render", scene("four"), "--set", "table_entries=4"}),
              HasSubstr("table_entries=4 holds 3 spheres and the light; the scene has 4"));
}

TEST_F(CliSphereTest, AsBuiltIsTold) {
  Program program(folder.path(),
                  {"render", scene("inside"), "--set", "as_built=on", "-o", "a.png", "--json"});
  EXPECT_EQ(program.wait(), 0);
  EXPECT_THAT(program.err(),
              HasSubstr("as_built=on: table_entries=5, when_full=drop, write_each_pass=on"));
}

TEST_F(CliSphereTest, AsBuiltDrawsWhatItStandsFor) {
  const auto drawn = [&](const std::vector<std::string>& knobs, const std::string& file) {
    std::vector<std::string> words = {
        "render", scene("inside"),       "--first", "23", "-o", file, "--json",
        "--set",  "write_buffer_depth=8"};
    for (const std::string& knob : knobs) words.insert(words.end(), {"--set", knob});
    return Json::parse(run(words)).at("pictures").at(0);
  };
  const Json built = drawn({"as_built=on"}, "a.png"), own = drawn({}, "c.png");
  EXPECT_EQ(built.dump(),
            drawn({"table_entries=5", "when_full=drop", "write_each_pass=on"}, "b.png").dump());
  EXPECT_TRUE(read_file(folder / "a.png") == read_file(folder / "b.png"));
  EXPECT_FALSE(read_file(folder / "a.png") == read_file(folder / "c.png")) << "words are lost";
  EXPECT_EQ(own.at("counters").at("words"), 320 * 240);
  EXPECT_EQ(own.at("counters").at("buffer_lost"), 0);
  EXPECT_GT(built.at("counters").at("words"), 320 * 240) << "one for each pass";
  EXPECT_GT(built.at("counters").at("buffer_lost"), 0);
}

TEST_F(CliSphereTest, AStarterChecksShowsAndRenders) {
  run({"scene", "new", "a.toml", "--engine", "sphere"});
  EXPECT_EQ(run({"scene", "check", "a.toml"}), "good: 2 spheres, 1 plane\n");
  EXPECT_THAT(run({"scene", "show", "a.toml"}), HasSubstr("antialias      none\n"));
  const Json shown = Json::parse(run({"scene", "show", "a.toml", "--json"}));
  EXPECT_EQ(shown.at("engine"), "sphere");
  EXPECT_EQ(shown.at("spheres"), 2);
  EXPECT_EQ(shown.at("moves"), true);
  run({"render", "a.toml", "--frames", "2", "--first", "118", "-o", "out"});
  EXPECT_THAT(read_file(folder / "out/frame_0119.png"), StartsWith("\x89PNG"));
}

TEST_F(CliSphereTest, NotesCountWhatRenderCounts) {
  run({"render", "sphere/inside", "--first", "12", "--frames", "1", "--stats", "s.json"});
  const Json picture = read_json(folder / "s.json").at("pictures").at(0);
  const Json& counters = picture.at("counters");
  run({"scene", "notes", "sphere/inside", "--frames", "1", "-o", "n.md"});
  const std::string text = read_file(folder / "n.md");
  EXPECT_THAT(text, HasSubstr("`racebeam scene notes inside --frames 1`\n"));
  const std::string clocks =
      fmt::format("{:.1f}", picture.at("per_pixel").at("clocks").get<double>());
  EXPECT_THAT(
      text,
      HasSubstr(fmt::format(
          "\n| inside | 1 of 24 | 3 | 2 | 1/1/planes | {} | {} | {} | {} | {} | {} | ", clocks,
          clocks, counters.at("primary_rays").get<int>(), counters.at("reflected_rays").get<int>(),
          counters.at("shadow_rays").get<int>(), counters.at("overflows").get<int>())));
  EXPECT_THAT(text, EndsWith(" | 1.5 % |\n")) << "the bound with planes";
}

TEST_F(CliSphereTest, NotesAreOfOneEngine) {
  EXPECT_EQ(refused({"scene", "notes", "demo", "sphere/four", "-o", "n.md"}),
            "racebeam: demo is a scene for beam, four one for sphere; write notes of each engine's "
            "apart\n");
  EXPECT_EQ(folder.files(), 0);
}

TEST_F(CliSphereTest, FaultsHaveLineColumnAndHelp) {
  std::ofstream(folder / "a.toml")
      << "engine = \"sphere\"\n[[sphere]]\ncentre = [0, 0, 20]\nradius = 99\n";
  for (const char* command : {"check", "show"})
    EXPECT_EQ(refused({"scene", command, "a.toml"}),
              "a.toml:4:10: 'radius' is 99\n  help: it must be in 1..63\n"
              "racebeam: 1 fault in a.toml\n");
}

TEST_F(CliSphereTest, WhatItDoesNotHaveIsRefused) {
  const std::string four = scene("four");
  EXPECT_THAT(refused({"render", four, "--wav", "a.wav"}), HasSubstr("sphere has no sound"));
  EXPECT_THAT(refused({"render", four, "--overlay", "cost"}),
              HasSubstr("--overlay shows intervals; sphere has none"));
  EXPECT_THAT(refused({"render", four, "--engine", "beam"}),
              HasSubstr("four is a scene for sphere; --engine sphere or leave --engine out"));
  EXPECT_THAT(refused({"scene", "plan", four, "-o", "a.png"}),
              HasSubstr("scene plan is for scenes of box rooms; four is a scene for sphere"));
}

}  // namespace
}  // namespace racebeam
