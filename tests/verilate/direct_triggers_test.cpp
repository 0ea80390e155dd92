// The triggers of Verilator's classes are known if they are a wrapper's clock, clocks of units in
// an island, and the input that others are taken with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/direct_triggers.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tb/verilate/verilator.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::SizeIs;

const std::string Ticks = "input wire racebeam_tick, input wire racebeam_take, input wire a";
const std::string Pulse =
    "reg seen = 0;\nwire racebeam_clock = racebeam_tick ^ seen;\n"
    "always @(posedge racebeam_clock) seen <= racebeam_tick;\n"
    "reg a_q = 0;\n"
    "always @(posedge racebeam_take or negedge racebeam_take) a_q <= a;\n";

/// Of classes that Verilator makes of a module `racebeam_wrapper` with a unit `mine` in it.
std::optional<DirectTriggers> triggers_of(const std::string& more, const std::string& mine) {
  const ScratchFolder folder;
  std::ofstream(folder / "wrapper.sv")
      << "module mine (input wire clk, input wire b, output reg c);\n" + mine + "endmodule\n" +
             "module racebeam_wrapper (" + Ticks + ", output wire c, output wire d);\n" + Pulse +
             more + "mine u_mine (.clk(racebeam_clock), .b(a_q), .c(c));\nendmodule\n";
  RtlSources sources;
  sources.top = "racebeam_wrapper";
  sources.files = {folder / "wrapper.sv"};
  write_rtl_classes(sources, folder.path(), false, [] {});
  return direct_triggers(folder.path());
}

const std::string Register = "always @(posedge clk) c <= b;\n";

TEST(DirectTriggersTest, AClockAndWhatIsTakenAreKnown) {
  const auto known = triggers_of("assign d = 0;\n", Register);
  ASSERT_TRUE(known);
  EXPECT_THAT(known->ticks, SizeIs(1));
  EXPECT_GE(known->take, 0);
  EXPECT_NE(known->ticks[0], known->take);
}

TEST(DirectTriggersTest, AUnitOfAnIslandMayHaveItsOwnClock) {
  const auto known = triggers_of(
      "wire u_clock = racebeam_clock | a;\nreg d_q;\nalways @(posedge u_clock) d_q <= a_q;\n"
      "assign d = d_q;\n",
      Register);
  ASSERT_TRUE(known);
  EXPECT_THAT(known->ticks, SizeIs(2));
}

TEST(DirectTriggersTest, OtherTriggersAreLookedFor) {
  const std::string none = "assign d = 0;\n";
  EXPECT_FALSE(
      triggers_of(none, "wire own_clock = clk & b;\nalways @(posedge own_clock) c <= b;\n"))
      << "a clock that the RTL makes";
  EXPECT_FALSE(triggers_of(none, "always @(negedge clk) c <= b;\n"));
  EXPECT_FALSE(triggers_of(none, Register + "assert property (@(posedge clk) b || !c);\n"))
      << "it looks at values from before";
  EXPECT_FALSE(direct_triggers(ScratchFolder().path())) << "no classes";
}

}  // namespace
}  // namespace racebeam
