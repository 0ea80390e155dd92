// The program with scenes of the voxel tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A world of one tile, and a picture of 16 x 8.
constexpr const char* Small = R"(engine = "voxel"
frames = 2
[terrain]
size = [32, 32, 16]
function = "tiny"
[picture]
size = [16, 8]
[camera]
position = [16, 0, 15]
fov = 8
[[crater]]
picture = 1
centre = [16, 12]
radius = 4
depth = 2
)";

class CliVoxelTest : public testing::Test {
 protected:
  CliVoxelTest() { std::ofstream(folder / "small.toml") << Small; }

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
  Json rendered(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"render", "small.toml", "--crc", "--stats", "s.json"};
    words.insert(words.end(), more.begin(), more.end());
    run(words);
    Json json = read_json(folder / "s.json");
    std::filesystem::remove(folder / "s.json");
    return json;
  }

  ScratchFolder folder;
};

TEST_F(CliVoxelTest, RendersTheVectorsWithTheirCounters) {
  run({"render", "voxel/tiny", "-o", "tiny.png", "--stats", "tiny.json"});
  EXPECT_THAT(read_file(folder / "tiny.png"), StartsWith("\x89PNG"));
  const Json stats = read_json(folder / "tiny.json");
  EXPECT_EQ(stats.at("engine"), "voxel");
  const Json& counters = stats.at("pictures").at(0).at("counters");
  EXPECT_EQ(counters.at("walk_clocks"), 312737);
  EXPECT_EQ(counters.at("fetches"), 65674);
  EXPECT_EQ(counters.at("moves"), 37028);
  EXPECT_EQ(counters.at("descents"), 25574);
  EXPECT_EQ(counters.at("raises"), 13286);
  EXPECT_EQ(counters.at("samples"), 7797);
}

TEST_F(CliVoxelTest, BothLevelsAndAllRtlLeaveTheSameButForTheirName) {
  Json tlm = rendered({"--level", "tlm"}), signal = rendered({"--level", "signal"});
  EXPECT_EQ(signal.at("level"), "signal");
  Json rtl = rendered({"--use", "all=rtl"});
  for (Json* json : {&tlm, &signal, &rtl}) {
    json->erase("level");
    json->erase("units");
  }
  EXPECT_EQ(tlm.dump(), signal.dump());
  EXPECT_EQ(tlm.at("pictures").dump(), rtl.at("pictures").dump());
}

TEST_F(CliVoxelTest, VerifyFindsNothing) {
  const auto json = Json::parse(run(
      {"verify", "all", "--scene", "small.toml", "--frames", "1", "--random", "2000", "--json"}));
  EXPECT_EQ(json["units"].size(), 26u + 4)
      << "thirteen units, alone and in the chip; the walks of four";
  for (const auto& unit : json["units"].elements()) EXPECT_EQ(unit["differences"], 0);
}

TEST_F(CliVoxelTest, TracesThePixelsOfAPicture) {
  run({"trace", "small.toml", "--from", "1:@3,2", "--pixels", "1", "-o", "v.vcd"});
  EXPECT_THAT(read_file(folder / "v.vcd"), HasSubstr("u_voxel_walker"));
}

TEST_F(CliVoxelTest, JudgesPicturesByExactColumns) {
  EXPECT_THAT(run({"render", "voxel/tiny", "--golden", "compare"}),
              HasSubstr("the chip beside double precision\npixels                         3072"));
}

TEST_F(CliVoxelTest, NewScenesAreGood) {
  run({"scene", "new", "my.toml", "--engine", "voxel"});
  EXPECT_THAT(run({"scene", "check", "my.toml"}), StartsWith("good: "));
  EXPECT_THAT(run({"scene", "show", "my.toml"}), HasSubstr("first hills, for voxel"));
}

TEST_F(CliVoxelTest, WhatCannotBeIsRefused) {
  EXPECT_THAT(refused({"render", "small.toml", "--set", "leaf=voxel"}),
              HasSubstr("leaf=voxel is for voxels of 1 x 1 x 1"));
  std::ofstream(folder / "odd.toml") << "engine = \"voxel\"\n[terrain]\nsize = [30, 32, 16]\n"
                                        "function = \"tiny\"\n";
  EXPECT_THAT(refused({"render", "odd.toml"}), HasSubstr("odd.toml:3:"));
}

TEST_F(CliVoxelTest, DrawsRoomsAndSpheresIfItIsAskedFor) {
  run({"render", "common/hall", "--engine", "voxel", "--frames", "1", "-o", "hall.png", "--stats",
       "hall.json"});
  EXPECT_EQ(read_json(folder / "hall.json").at("engine"), "voxel");
  EXPECT_THAT(refused({"render", "block/quad", "--engine", "voxel"}), HasSubstr("quad"));
}

}  // namespace
}  // namespace racebeam
