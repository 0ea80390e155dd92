// `racebeam verify` and `render --use` through the command line, with good and bad RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string Rtl = rtl_file("stacks");

class CliVerifyTest : public testing::Test {
 protected:
  /// A copy of the RTL of a unit with one place changed.
  std::string changed(const std::string& from, const std::string& to,
                      const std::string& unit = "stacks") {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(folder / "mine.sv") << text.replace(at, from.size(), to);
    return unit + "=mine.sv";
  }
  void expect_refused(const std::string& unit, const std::vector<std::string>& said) {
    Program run(folder.path(), {"verify", unit, "--frames", "0"});
    EXPECT_EQ(run.wait(), 2);
    for (const std::string& words : said) EXPECT_THAT(run.err(), HasSubstr(words));
  }

  ScratchFolder folder;
};

TEST_F(CliVerifyTest, FindsNoDifferenceInTheUnitsOwnRtl) {
  for (const char* unit : {"stacks", "stacks=rtl"}) {
    Program run(folder.path(), {"verify", unit, "--frames", "1", "--random", "20000", "--json"});
    EXPECT_EQ(run.wait(), 0) << run.err();
    const auto json = Json::parse(run.out());
    ASSERT_EQ(json["units"].size(), 2u);
    for (const auto& row : json["units"].elements()) {
      EXPECT_EQ(row["differences"], 0);
      EXPECT_TRUE(row["first"].is_null());
    }
    EXPECT_EQ(json["units"][0]["clocks"], 20000);
    EXPECT_EQ(json["units"][1]["clocks"], 840001);
  }
}

TEST_F(CliVerifyTest, FindsTheFaultOfChangedRtlAndShowsWhatLedThere) {
  const std::string mine = changed("(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  Program run(folder.path(), {"verify", mine, "--frames", "1", "--random", "1000"});
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.err(), HasSubstr("top_i2_o rtl"));
  EXPECT_THAT(run.err(), HasSubstr("in frame 0, line -2"));
  EXPECT_THAT(run.err(), HasSubstr("repeat: racebeam verify stacks"));
}

TEST_F(CliVerifyTest, NamesTheOneUnitOfAllThatDiffers) {
  const std::string mine = changed("(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  Program run(folder.path(), {"verify", "all", mine, "--frames", "1", "--random", "1000"});
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.out(), testing::ContainsRegex("\nsubdivider +chip +840001 +[0-9]+ +0 "));
  EXPECT_THAT(run.err(), HasSubstr("racebeam: stacks: port top_tag_o differs in frame 0, line "));
  for (const char* other : {"subdivider: ", "decision_datapath: ", "racebeam_top: "})
    EXPECT_THAT(run.err(), Not(HasSubstr(other)));
}

TEST_F(CliVerifyTest, NamesTheWireOfAChipThatIsWiredWrongly) {
  const std::string mine =
      changed(".half_size_y_i(half_size_y)", ".half_size_y_i(half_size_x)", "racebeam_top");
  Program run(folder.path(), {"verify", mine, "--frames", "1", "--random", "0"});
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.err(), HasSubstr("racebeam_top: port uo_o differs in frame 0, line "));
  EXPECT_THAT(run.err(), HasSubstr("u_decision_datapath.half_size_y_i has 0x80 instead of "));
  EXPECT_THAT(run.err(), HasSubstr(", the value of u_scene.half_size_y_o.\nNo unit is to blame"));
}

TEST_F(CliVerifyTest, GivesTheFirstDifferenceAsNumbers) {
  const std::string mine = changed("(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  Program run(folder.path(), {"verify", mine, "--frames", "2", "--random", "1000", "--json"});
  EXPECT_EQ(run.wait(), 1);
  const auto units = run.json()["units"];
  ASSERT_EQ(units.size(), 2u);
  const auto random = units[0]["first"], chip = units[1]["first"];
  const auto port = random["port"].get<std::string>();
  EXPECT_EQ(port.substr(0, 4), "top_");
  EXPECT_LT(random["clock"], 1000);
  EXPECT_NE(random["expected"], random["got"]);
  EXPECT_FALSE(random.contains("place"));
  EXPECT_THAT(random["text"].get<std::string>(), HasSubstr(port + " rtl"));
  const auto place = chip["place"];
  EXPECT_EQ(place["frame"], 0);
  EXPECT_EQ(chip["clock"].get<int>(),
            1 + (place["line"].get<int>() + 273) * 1600 + place["clock"].get<int>());
  EXPECT_EQ(units[1]["clocks"], 840001) << "the second frame could tell nothing new";
}

TEST_F(CliVerifyTest, RefusesRtlThatDoesNotFit) {
  expect_refused(changed("input  wire logic push_en_i,", ""), {"mine.sv", "push_en_i"});
  expect_refused(changed("[racebeam_pkg::PixelBits-1:0] i2_i", "[7:0] i2_i"),
                 {"port i2_i is 8 bits wide instead of 10"});
  expect_refused(changed("input  wire logic fwrite_i",
                         "input wire logic spare_i,\n input wire logic fwrite_i"),
                 {"port spare_i is not a port of the unit", "stacks.h below sc/"});
  expect_refused(changed("endmodule", "endmodul"), {"cannot be verilated", "syntax error"});
  expect_refused("stacks=none.sv", {"there is no file 'none.sv'"});
  expect_refused("stakcs", {"unknown unit 'stakcs'; did you mean 'stacks'?"});
}

TEST_F(CliVerifyTest, RtlInTheChipGivesThePinsOfTheModel) {
  const auto crc_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render", "demo",  "--first", "7223",
                                          "--json", "--crc", "--stats", "s.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 0) << run.err();
    return Json::parse(run.out())["frames"][0]["pins_crc32"];
  };
  const auto model = crc_with({});
  EXPECT_EQ(crc_with({"--use", "stacks=rtl"}), model);
  EXPECT_EQ(crc_with({"--use", "stacks=lockstep"}), model);
  EXPECT_EQ(crc_with({"--use", "stacks=" + Rtl}), model);
}

}  // namespace
}  // namespace racebeam
