// `verify --power-up`: what a unit's outputs owe to its registers at power-up, with the register.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliPowerUpTest : public testing::Test {
 protected:
  /// The RTL of vga_timing with a text of it replaced.
  void write(const std::string& text, const std::string& instead) {
    std::string rtl = read_file(RACEBEAM_SOURCE_DIR "/rtl/video/vga_timing.sv");
    const auto at = rtl.find(text);
    ASSERT_NE(at, std::string::npos) << text;
    std::ofstream(folder / "mine.sv") << rtl.replace(at, text.size(), instead);
  }
  void run(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--frames", "0", "--random", "0"});
    arguments.insert(arguments.begin(), "verify");
    Program program(folder.path(), arguments);
    code = program.wait();
    out = program.out();
    said = program.err();
  }

  ScratchFolder folder;
  int code = 0;
  std::string out, said;
};

TEST_F(CliPowerUpTest, OurRtlShowsNothingOfItsPowerUp) {
  run({"vga_timing", "--power-up", "20", "--json"});
  EXPECT_EQ(code, 0) << said;
  const Json units = Json::parse(out)["units"];
  ASSERT_EQ(units.size(), 1u);
  EXPECT_EQ(units[0]["traffic"], "power-up");
  EXPECT_EQ(units[0]["clocks"], 22 * 10000) << "zeros, ones and 20 seeds";
  EXPECT_EQ(units[0]["differences"], 0);
}

TEST_F(CliPowerUpTest, TheRegisterThatTheResetMissesIsNamed) {
  write("      half_q <= '0;\n", "");
  run({"vga_timing=mine.sv", "--power-up", "5"});
  EXPECT_EQ(code, 1);
  EXPECT_THAT(said, HasSubstr("vga_timing: the reset misses the register half_q: what it has at "
                              "power-up shows at x2_o in clock 1"));
  EXPECT_THAT(said, HasSubstr("repeat: racebeam verify vga_timing=mine.sv"));
  EXPECT_THAT(said, HasSubstr("--power-up 5"));
  EXPECT_THAT(said, Not(HasSubstr("register vs_q"))) << "the contract leaves that one so";
}

TEST_F(CliPowerUpTest, UnitsWithoutAResetAreLeftOut) {
  for (const char* unit : {"stacks", "ray_stepper"}) {  // of that an input is called a reset
    run({unit, "--power-up", "20", "--json"});
    EXPECT_EQ(code, 0) << said;
    EXPECT_EQ(Json::parse(out)["units"][0]["clocks"], 0) << unit;
  }
}

TEST_F(CliPowerUpTest, WhatTheResetMovesOfARegisterThatTheContractLeavesIsNoFault) {
  run({"subdivider", "--power-up", "20", "--json"});
  EXPECT_EQ(code, 0) << said;
  EXPECT_EQ(Json::parse(out)["units"][0]["clocks"], 22 * 10000);
}

TEST_F(CliPowerUpTest, NumbersThatAreNoneAreRefused) {
  for (const char* number : {"-1", "x", "2000000"}) {
    run({"vga_timing", "--power-up", number});
    EXPECT_EQ(code, 2) << number;
    EXPECT_THAT(said, HasSubstr("--power-up")) << number;
  }
}

}  // namespace
}  // namespace racebeam
