// The program with scenes of the block renderer.
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

class CliBlockTest : public testing::Test {
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

TEST_F(CliBlockTest, RendersAPictureWithItsCounters) {
  run({"render", "block/quad", "--set", "cores=1", "-o", "quad.png", "--stats", "quad.json"});
  EXPECT_THAT(read_file(folder / "quad.png"), StartsWith("\x89PNG"));
  const Json stats = read_json(folder / "quad.json");
  EXPECT_EQ(stats.at("engine"), "block");
  const Json& picture = stats.at("pictures").at(0);
  EXPECT_EQ(picture.at("clocks"), 3173801);
  EXPECT_EQ(picture.at("counters").at("host_clocks"), 48);
  EXPECT_EQ(picture.at("counters").at("busy_clocks"), 3172601);
  EXPECT_EQ(picture.at("counters").at("cleared"), 936);
}

TEST_F(CliBlockTest, JudgesPicturesByDoublePrecision) {
  EXPECT_THAT(run({"render", "block/bounce", "--golden", "compare", "--frames", "1"}),
              HasSubstr("the chip beside double precision\npixels                       307200"));
}

TEST_F(CliBlockTest, NewScenesAreGood) {
  run({"scene", "new", "my.toml", "--engine", "block"});
  EXPECT_EQ(run({"scene", "check", "my.toml"}), "good: 2 spheres\n");
  EXPECT_THAT(run({"scene", "show", "my.toml"}), HasSubstr("first blocks, for block"));
}

TEST_F(CliBlockTest, WhatItsNumbersCannotHoldIsRefusedWithItsPlace) {
  std::ofstream(folder / "large.toml")
      << "engine = \"block\"\n[[sphere]]\ncentre = [0, 0, 6]\nradius = 3\n";
  EXPECT_THAT(refused({"render", "large.toml"}),
              HasSubstr("large.toml:4:10: 'radius' is 3, scaled\n  help: 1/64 and more"));
  EXPECT_THAT(refused({"render", "block/quad", "--set", "size=100x100"}),
              HasSubstr("it takes 640x480, 512x480, 1920x1080"));
}

TEST_F(CliBlockTest, DrawsASceneOfSeveralEnginesIfItIsAskedFor) {
  run({"render", "common/rising-1", "--engine", "block", "--frames", "1", "-o", "one.png",
       "--stats", "one.json"});
  EXPECT_EQ(read_json(folder / "one.json").at("engine"), "block");
  EXPECT_THAT(refused({"render", "sphere/four", "--engine", "block"}),
              HasSubstr("four is a scene for sphere; --engine sphere or leave --engine out"));
}

}  // namespace
}  // namespace racebeam
