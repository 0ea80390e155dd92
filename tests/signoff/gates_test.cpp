// Sign-off of gates: good ones, RTL with a fault, gates that are too slow, tools that are missing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/gates.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "sc/beam/engine.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tests/support/fake_mapping.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;

UnitUnderTest dut(const std::string& unit) {
  return {unit, "", beam_engine().standard(nullptr), nullptr, 0};
}

GatesOptions quick() {
  GatesOptions options;
  options.clocks = 3000;
  return options;
}

TEST(SignOffGates, GoodGatesHaveFigures) {
  const CheckResult result = sign_off_gates(dut("interval_fifo"), quick());
  EXPECT_EQ(result.verdict, CheckResult::Good) << result.summary;
  EXPECT_EQ(result.unit, "interval_fifo");
  EXPECT_EQ(result.check, "gates");
  EXPECT_TRUE(result.faults.empty());
  EXPECT_THAT(result.summary, AllOf(HasSubstr("generic same for 3000 clocks"),
                                    HasSubstr("osu018 same for 3000 clocks"), HasSubstr("slack")));
  EXPECT_EQ(result.detail["clocks"], 3000);
  EXPECT_EQ(result.detail["generic"]["same"], true);
  EXPECT_EQ(result.detail["osu018"]["same"], true);
  EXPECT_GT(result.detail["osu018"]["flip_flops"], 50);
  EXPECT_GT(result.detail["osu018"]["area"], 1000);
  EXPECT_GT(result.detail["osu018"]["slack"], 0);
}

// One entry of the FIFO is compared with the wrong length.
TEST(SignOffGates, AFaultOfTheRtlIsInItsGates) {
  const ScratchFolder folder;
  std::string text = whole_file(rtl_file("interval_fifo"));
  const std::string good = "(head_len_q >>> ShortBits) > 0";
  ASSERT_NE(text.find(good), std::string::npos);
  std::ofstream(folder / "mine.sv")
      << text.replace(text.find(good), good.size(), "(head_len_q >>> ShortBits) > 1");
  GatesOptions options = quick();
  options.clocks = 20'000;
  options.file = folder / "mine.sv";
  const CheckResult result = sign_off_gates(dut("interval_fifo"), options);
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  ASSERT_EQ(result.faults.size(), 2u) << "of each kind";
  EXPECT_THAT(result.faults[0], AllOf(HasSubstr("gates of generic: port "), HasSubstr(" in clock "),
                                      HasSubstr("racebeam verify interval_fifo=gates:generic:")));
  EXPECT_EQ(result.detail["generic"]["first"], result.detail["osu018"]["first"]);
}

TEST(SignOffGates, TooLittleSlackIsAFault) {
  GatesOptions options = quick();
  options.least_slack = 19.8;
  const CheckResult result = sign_off_gates(dut("stacks"), options);
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.summary, AllOf(HasSubstr("slack "), HasSubstr("less than 19.8")));
}

TEST(SignOffGates, AStaThatSaysNothingIsAFault) {
  const FakeTool silent("sta", "exit 0");
  const CheckResult result = sign_off_gates(dut("stacks"), quick());
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.summary, HasSubstr("sta has not found the WORST path of stacks"));
}

TEST(SignOffGates, WithoutToolsItIsUndecided) {
  const ScratchFolder nothing;
  const std::string path = std::getenv("PATH");
  setenv("PATH", nothing.path().c_str(), 1);
  const CheckResult result = sign_off_gates(dut("stacks"), quick());
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(result.verdict, CheckResult::Undecided);
  EXPECT_THAT(result.summary, HasSubstr("is not installed"));
}

}  // namespace
}  // namespace racebeam
