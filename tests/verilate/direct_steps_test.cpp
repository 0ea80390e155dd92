// What follows in Verilator's classes is known if it follows from a wrapper's clock, clocks of
// units in an island, and inputs that others are taken with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/direct_steps.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tb/verilate/verilator.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::Ge;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;
using testing::SizeIs;
using testing::UnorderedElementsAre;

const std::string Ticks =
    "input wire racebeam_tick, input wire racebeam_take_0, input wire racebeam_take_1, "
    "input wire a, input wire b";
const std::string Pulse =
    "reg seen = 0;\nwire racebeam_clock = racebeam_tick ^ seen;\n"
    "always @(posedge racebeam_clock) seen <= racebeam_tick;\n"
    "reg a_q = 0, b_q = 0;\n"
    "always @(posedge racebeam_take_0 or negedge racebeam_take_0) a_q <= a;\n"
    "always @(posedge racebeam_take_1 or negedge racebeam_take_1) b_q <= b;\n";

/// Of classes that Verilator makes of a module `racebeam_wrapper` with a unit `mine` in it.
std::optional<DirectSteps> steps_of(const std::string& more, const std::string& mine) {
  const ScratchFolder folder;
  std::ofstream(folder / "wrapper.sv")
      << "module mine (input wire clk, input wire b, output reg c);\n" + mine + "endmodule\n" +
             "module racebeam_wrapper (" + Ticks + ", output wire c, output wire d);\n" + Pulse +
             more + "mine u_mine (.clk(racebeam_clock), .b(a_q), .c(c));\nendmodule\n";
  RtlSources sources;
  sources.top = "racebeam_wrapper";
  sources.files = {folder / "wrapper.sv"};
  write_rtl_classes(sources, folder.path(), false, [] {});
  return direct_steps(folder.path());
}

const std::string Register = "always @(posedge clk) c <= b;\n";

/// How many functions follow from the clock, and from each group.
std::pair<int, std::map<int, int>> counts(const DirectSteps& steps) {
  std::pair<int, std::map<int, int>> all;
  for (const DirectStep& step : steps.registers) {
    all.first += step.at_tick;
    for (const int group : step.groups) ++all.second[group];
  }
  return all;
}

TEST(DirectStepsTest, OfAClockAndWhatIsTakenAreKnown) {
  const auto known = steps_of("assign d = b_q;\n", Register);
  ASSERT_TRUE(known);
  EXPECT_THAT(known->inputs, Not(IsEmpty())) << "the clock follows from the tick";
  const auto [at_tick, groups] = counts(*known);
  EXPECT_GE(at_tick, 1);
  EXPECT_THAT(groups, UnorderedElementsAre(Pair(0, Ge(1)), Pair(1, Ge(1))));
  for (const DirectStep& step : known->registers)
    EXPECT_FALSE(step.at_tick && step.groups.count(0) != 0) << "a_q goes into a register alone";
}

TEST(DirectStepsTest, FollowFromWhateverTheyHangOn) {
  const auto known = steps_of("assign d = b_q ^ c;\n", Register);
  ASSERT_TRUE(known);
  const auto& steps = known->registers;
  EXPECT_TRUE(std::any_of(steps.begin(), steps.end(), [](const DirectStep& step) {
    return step.at_tick && step.groups == std::set<int>{1};
  })) << "d hangs on the register c and on b";
}

TEST(DirectStepsTest, AUnitOfAnIslandMayHaveItsOwnClock) {
  const auto known = steps_of(
      "wire u_clock = racebeam_clock | a;\nreg d_q;\nalways @(posedge u_clock) d_q <= a_q;\n"
      "assign d = d_q;\n",
      Register);
  ASSERT_TRUE(known);
  EXPECT_GE(counts(*known).first, 2) << "it rises with the island's";
}

/// Logic of many statements from `input` to c, and `more`.
std::string much_logic(const std::string& input, const std::string& more) {
  std::string text =
      "reg [31:0] q = 0, mixed;\nalways @(posedge clk) if (b) q <= q + 1;\n"
      "always @* begin\nmixed = " +
      input + ";\n";
  for (int n = 0; n < 150; ++n)
    text += "if (mixed[" + std::to_string(n % 32) + "]) mixed = mixed * 32'd" +
            std::to_string(2 * n + 3) + " + " + input + ";\n";
  return text + "c = ^mixed;\n" + more + "end\n";
}

/// Those that are called at a tick, of so many statements that it pays to ask whether they need be.
std::vector<DirectStep> needed_sometimes(const std::string& mine) {
  const auto known = steps_of("assign d = 0;\n", mine);
  EXPECT_TRUE(known);
  std::vector<DirectStep> steps;
  if (known)
    std::copy_if(known->registers.begin(), known->registers.end(), std::back_inserter(steps),
                 [](const DirectStep& step) { return !step.always; });
  return steps;
}

TEST(DirectStepsTest, MuchLogicIsComputedAgainIfARegisterBeforeItHasChanged) {
  const auto steps = needed_sometimes(much_logic("(q ^ {32{b}})", ""));
  ASSERT_THAT(steps, SizeIs(1));
  EXPECT_THAT(steps[0].changed, ElementsAre(EndsWith("__DOT__q")));
  EXPECT_THAT(steps[0].called, IsEmpty());
}

TEST(DirectStepsTest, WhatSpeaksOrIsShortIsComputedAtEachTick) {
  EXPECT_THAT(needed_sometimes(much_logic("(q ^ {32{b}})", "$display(\"%d\", mixed);\n")),
              IsEmpty());
  EXPECT_THAT(needed_sometimes(Register), IsEmpty());
}

TEST(DirectStepsTest, OtherTriggersAreLookedFor) {
  const std::string none = "assign d = 0;\n";
  EXPECT_FALSE(steps_of(none, "wire own_clock = clk & b;\nalways @(posedge own_clock) c <= b;\n"))
      << "a clock that the RTL makes";
  EXPECT_FALSE(steps_of(none, "always @(negedge clk) c <= b;\n"));
  EXPECT_FALSE(steps_of(none, Register + "assert property (@(posedge clk) b || !c);\n"))
      << "it looks at values from before";
  EXPECT_FALSE(direct_steps(ScratchFolder().path())) << "no classes";
}

}  // namespace
}  // namespace racebeam
