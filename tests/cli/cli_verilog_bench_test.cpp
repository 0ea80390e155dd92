// `racebeam verify --bench-out`: a test bench in Verilog that passes in Icarus with a netlist and
// in Verilator with the RTL, and fails there as verify does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliVerilogBenchTest : public testing::TestWithParam<const char*> {
 protected:
  /// In the folder; its exit code, and what it says in `said`.
  int shell(const std::string& command) {
    const int status =
        std::system(("cd '" + folder.path() + "' && { " + command + "; } >said 2>&1").c_str());
    said = read_file(folder / "said");
    return WEXITSTATUS(status);
  }
  int verify(const std::string& unit, const Words& more) {
    Words words = {"verify", unit, "--bench-out", "bench.v"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    const int code = run.wait();
    said = run.err();
    out = run.out();
    return code;
  }
  /// The bench with the gates of a unit, UNIT or UNIT=FILE.sv.
  int in_icarus(const std::string& unit) {
    if (shell("'" RACEBEAM_SOURCE_DIR "/scripts/netlist' --gates " + unit + " gates.v") != 0 ||
        shell("iverilog -g2001 -DDEPOSIT -o bench bench.v gates.v") != 0)
      return -1;
    return shell("vvp -N bench");
  }
  int in_verilator(const std::string& unit) {
    if (shell("verilator --binary --timing -O0 --top-module " + unit + "_bench --Mdir v bench.v '" +
              rtl_file("racebeam_pkg") + "' '" + rtl_file(unit) +
              "' -y '" RACEBEAM_SOURCE_DIR "/rtl/beam'") != 0)
      return -1;
    return shell("v/V" + unit + "_bench");
  }
  static bool has_icarus() { return std::system("iverilog -V >/dev/null 2>&1") == 0; }

  ScratchFolder folder;
  std::string said, out;
};

TEST_F(CliVerilogBenchTest, PassesWithTheGatesOfTheUnitInIcarus) {
  if (!has_icarus()) GTEST_SKIP() << "there is no iverilog; scripts/setup test installs it";
  ASSERT_EQ(verify("stacks", {"--random", "500"}), 0) << said;
  EXPECT_EQ(in_icarus("stacks"), 0) << said;
  EXPECT_THAT(said, HasSubstr("PASS: stacks, 500 clocks"));
}

TEST_F(CliVerilogBenchTest, AFaultFailsThereAtThePortAndClockThatVerifyNames) {
  if (!has_icarus()) GTEST_SKIP() << "there is no iverilog; scripts/setup test installs it";
  std::string text = read_file(rtl_file("scene"));
  const std::string right = "-(CornerBits'(272))", wrong = "-(CornerBits'(271))";
  const auto at = text.find(right);
  ASSERT_NE(at, std::string::npos);
  std::ofstream(folder / "mine.sv") << text.replace(at, right.size(), wrong);
  ASSERT_EQ(verify("scene=mine.sv", {"--json"}), 1) << said;
  const Json first = Json::parse(out)["units"][0]["first"];
  const Json shrunk = first["shrunk"];
  EXPECT_EQ(in_icarus("scene=mine.sv"), 1) << said;
  EXPECT_THAT(said,
              HasSubstr(fmt::format(
                  "FAIL: port {}, clock {}: expected {:x}, got {:x}\n",
                  first["port"].get<std::string>(), shrunk["clocks"].get<std::uint64_t>(),
                  shrunk["expected"].get<std::uint64_t>(), shrunk["got"].get<std::uint64_t>())));
  EXPECT_EQ(in_icarus("scene"), 0) << "the unit's own RTL passes: " << said;
}

TEST_F(CliVerilogBenchTest, WhatHasNoBenchIsRefused) {
  EXPECT_EQ(verify("all", {}), 2);
  EXPECT_THAT(said, HasSubstr("--bench-out is for one unit"));
  EXPECT_EQ(verify("stacks", {"camera_unit"}), 2);
  EXPECT_EQ(verify("stacks", {"--random", "0"}), 2);
  EXPECT_THAT(said, HasSubstr("--bench-out is of random traffic or of a --stream"));
  EXPECT_EQ(verify("stacks", {"--frames", "1"}), 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "bench.v"));
}

class LongBenchInIcarus : public CliVerilogBenchTest {};
class LongBenchInVerilator : public CliVerilogBenchTest {};

TEST_P(LongBenchInIcarus, PassesWithTheGates) {
  ASSERT_EQ(verify(GetParam(), {"--random", "2000"}), 0) << said;
  EXPECT_EQ(in_icarus(GetParam()), 0) << said;
  EXPECT_THAT(said, HasSubstr("PASS: "));
}

TEST_P(LongBenchInVerilator, PassesWithTheRtl) {
  ASSERT_EQ(verify(GetParam(), {"--random", "500"}), 0) << said;
  EXPECT_EQ(in_verilator(GetParam()), 0) << said;
  EXPECT_THAT(said, HasSubstr("PASS: "));
}

INSTANTIATE_TEST_SUITE_P(LongUnits, LongBenchInIcarus,
                         testing::Values("vga_timing", "sequencer", "camera_unit", "ray_stepper",
                                         "subdivider", "stacks", "decision_datapath", "scene",
                                         "navigator", "interval_fifo", "pixel_output", "pwm_sound"),
                         [](const auto& test) { return std::string(test.param); });
INSTANTIATE_TEST_SUITE_P(LongUnits, LongBenchInVerilator,
                         testing::Values("vga_timing", "sequencer", "camera_unit", "ray_stepper",
                                         "subdivider", "stacks", "decision_datapath", "scene",
                                         "navigator", "interval_fifo", "pixel_output", "pwm_sound"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace racebeam
