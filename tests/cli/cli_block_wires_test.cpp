// The program with the wires of the block renderer: render, verify, trace, units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/cli_trace_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// A ball on four blocks.
constexpr const char* One =
    "name = \"one\"\nengine = \"block\"\nframes = 1\n[[sphere]]\ncentre = [0, 0, 3]\nradius = "
    "0.25\n";

class CliBlockWiresTest : public CliTraceBench {
 protected:
  CliBlockWiresTest() { std::ofstream(folder / "one.toml") << One; }

  std::string run(const std::vector<std::string>& words) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.out();
  }
  /// The RTL of a core with a background of its own, in mine.sv.
  void change_core() {
    const std::string from = "24'(Background)";
    std::string text = read_file(rtl_file("block_core"));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    std::ofstream(folder / "mine.sv") << text.replace(at, from.size(), "24'h010203");
  }
  Json rendered(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"render", "one.toml", "--crc", "--stats", "s.json"};
    words.insert(words.end(), more.begin(), more.end());
    run(words);
    Json json = read_json(folder / "s.json");
    std::filesystem::remove(folder / "s.json");
    return json;
  }
};

TEST_F(CliBlockWiresTest, BothLevelsLeaveTheSameButForTheirName) {
  Json tlm = rendered({"--level", "tlm"}), signal = rendered({"--level", "signal"});
  EXPECT_EQ(signal.at("level"), "signal");
  tlm.erase("level");
  signal.erase("level");
  EXPECT_EQ(tlm.dump(), signal.dump());
}

TEST_F(CliBlockWiresTest, RtlOfACoreIsInAllCores) {
  change_core();
  run({"render", "one.toml", "--set", "background=66051", "-o", "a.png"});
  run({"render", "one.toml", "--use", "block_core=mine.sv", "-o", "b.png"});
  EXPECT_TRUE(read_file(folder / "a.png") == read_file(folder / "b.png"));
}

TEST_F(CliBlockWiresTest, VerifyGoesThroughAPicture) {
  const auto json = Json::parse(
      run({"verify", "all", "--scene", "one.toml", "--frames", "1", "--random", "2000", "--json"}));
  EXPECT_EQ(json["units"].size(), 16u + 3)
      << "eight units, alone and in the chip; the walks of three";
  for (const auto& unit : json["units"].elements()) EXPECT_EQ(unit["differences"], 0);
}

TEST_F(CliBlockWiresTest, VerifyTellsThePlaceInThePicture) {
  change_core();
  Program program(folder.path(), {"verify", "block_core=mine.sv", "--scene", "one.toml", "--frames",
                                  "1", "--random", "0"});
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.err(), HasSubstr("block_core: port word_o differs in picture 0, clock "));
  EXPECT_THAT(program.err(), HasSubstr(" --from 0:0 --use block_core=lockstep:mine.sv"));
}

TEST_F(CliBlockWiresTest, WavesHaveEachCoreInAScopeOfItsOwn) {
  const Wave wave = trace({"--from", "0:20", "--to", "0:30"}, "t.vcd", "one.toml");
  EXPECT_EQ(wave["chip.g_core[0].u_block_core.state_q_name"].at(wave.begin), "JOB");
  EXPECT_EQ(wave["chip.g_core[0].u_block_core.state_q_name"].at(wave.end - Period), "CORNER");
  EXPECT_EQ(wave["chip.g_core[3].u_block_core.state_q"].number(wave.begin), 0u);
  EXPECT_EQ(wave["chip.g_core[3].job_ready"].number(wave.begin), 1u);
}

}  // namespace
}  // namespace racebeam
