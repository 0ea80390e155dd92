// The check of resets: our units are good, and a register that a reset misses is named, with the
// port and the clock where it shows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/reset.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>

#include "tb/scene/engines.h"
#include "tb/signoff/four_state.h"
#include "tb/signoff/from_reset.h"
#include "tb/twin/twins.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string read_file(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

ResetOptions quick() {
  ResetOptions options;
  options.starts.seeds = 20;
  options.starts.clocks = 3000;
  options.four_state_clocks = 1000;
  return options;
}

UnitUnderTest unit(const engine& built, const std::string& name, const std::string& plugin = "") {
  return {name, plugin, built.standard(nullptr), nullptr, 1};
}

/// The RTL of vga_timing with a text of it replaced, signals readable.
class ResetOfVgaTiming : public testing::Test {
 protected:
  std::string plugin(const std::string& text, const std::string& instead) {
    std::string rtl = read_file(RACEBEAM_SOURCE_DIR "/rtl/video/vga_timing.sv");
    const auto at = rtl.find(text);
    EXPECT_NE(at, std::string::npos) << text;
    std::ofstream(folder / "mine.sv") << rtl.replace(at, text.size(), instead);
    const UnitUnderTest dut = unit(*engines().front(), "vga_timing");
    return twins().front().plugins(dut.k, nullptr, true).users("vga_timing", folder / "mine.sv");
  }
  CheckResult check(const std::string& plugin) {
    return sign_off_reset(unit(*engines().front(), "vga_timing", plugin), quick());
  }

  ScratchFolder folder;
};

TEST_F(ResetOfVgaTiming, WhatTheContractLeavesWithoutResetIsGoodAndNamed) {
  const CheckResult result = check("");
  EXPECT_EQ(result.verdict, CheckResult::Good) << testing::PrintToString(result.faults);
  EXPECT_THAT(result.faults, IsEmpty());
  const auto& unreset = result.detail["unreset"];
  ASSERT_EQ(unreset.size(), 1u) << unreset.dump();
  EXPECT_EQ(unreset[0]["name"], "vs_q");
  EXPECT_EQ(unreset[0]["port"], "vsync_no");
  EXPECT_NE(unreset[0]["reason"], "");
  EXPECT_EQ(result.detail["starts"], 22);
  EXPECT_THAT(result.detail["four_state"]["pins"], IsEmpty());
}

TEST_F(ResetOfVgaTiming, ARegisterThatItMissesIsNamedWithPortAndClock) {
  const CheckResult result = check(plugin("      half_q <= '0;\n", ""));
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.faults, Contains(testing::AllOf(HasSubstr("misses the register half_q"),
                                                     HasSubstr("shows at x2_o in clock 1"))));
  EXPECT_THAT(result.detail["four_state"]["registers"], Contains("half_q"));
  EXPECT_THAT(result.detail["four_state"]["pins"], Not(IsEmpty()));
}

TEST_F(ResetOfVgaTiming, ARegisterThatIsResetAfterAllIsAnOldException) {
  const CheckResult result = check(plugin("    vs_q <= vs_d;\n", "    vs_q <= rst_ni && vs_d;\n"));
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.faults, Contains(HasSubstr("contract_registers.cpp names vs_q")));
}

TEST_F(ResetOfVgaTiming, ARegisterThatNoPinShowsIsNoFault) {
  const CheckResult result =
      check(plugin("  always_ff @(posedge clk_i) begin\n",
                   "  logic [3:0] spare_q /* verilator public_flat_rw */;\n"
                   "  always_ff @(posedge clk_i) begin\n    spare_q <= spare_q + 4'd1;\n"));
  EXPECT_EQ(result.verdict, CheckResult::Good) << testing::PrintToString(result.faults);
  EXPECT_THAT(result.detail["unreset"].dump(), HasSubstr("spare_q"));
}

class LongEveryUnit : public testing::TestWithParam<std::string> {};

TEST_P(LongEveryUnit, ShowsNothingOfItsPowerUpAfterTheReset) {
  const UnitUnderTest dut = unit(engine_of_unit(GetParam()), GetParam());
  ResetOptions options;
  options.starts.clocks = clocks_from_reset(dut, options.starts.clocks);
  options.starts.one_by_one = !is_whole_chip(dut);
  const CheckResult result = sign_off_reset(dut, options);
  std::printf("%s: %s, %.1f s\n", result.unit.c_str(), result.summary.c_str(), result.seconds);
  for (const std::string& fault : result.faults) std::printf("  %s\n", fault.c_str());
  EXPECT_EQ(result.verdict, CheckResult::Good);
}

std::set<std::string> all_units() {  // some belong to several engines
  std::set<std::string> all;
  for (const engine* built : engines()) {
    for (const std::string& name : built->unit_names(false)) all.insert(name);
    if (*built->top) all.insert(built->top);
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(LongUnits, LongEveryUnit, testing::ValuesIn(all_units()),
                         [](const auto& unit) { return unit.param; });

}  // namespace
}  // namespace racebeam
