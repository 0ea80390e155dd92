// A chip that makes no progress ends, and says who waits for whom: one deadlock or livelock is
// planted in the RTL of a unit at a time, and the last of the chain is that unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

struct Plant {
  const char *name, *unit;    ///< of the test; that the chain must end with
  const char *right, *wrong;  ///< text of the RTL, and what stands there instead
  const char* scene = "demo";
  const char* folder = "beam";
};
void PrintTo(const Plant& plant, std::ostream* out) { *out << plant.name; }

constexpr const char* Voxel = RACEBEAM_SOURCE_DIR "/tests/museum/voxel.toml";
constexpr const char* Block = RACEBEAM_SOURCE_DIR "/tests/museum/block.toml";

class CliHangTest : public testing::TestWithParam<Plant> {
 protected:
  void plant() {
    const Plant& p = GetParam();
    std::string text =
        read_file(std::string(RACEBEAM_SOURCE_DIR "/rtl/") + p.folder + "/" + p.unit + ".sv");
    const auto at = text.find(p.right);
    ASSERT_NE(at, std::string::npos) << p.right;
    text.replace(at, std::string(p.right).size(), p.wrong);
    std::ofstream(folder / "mine.sv") << text;
  }
  ScratchFolder folder;
};

TEST_P(CliHangTest, IsNamedAtTheEndOfTheChain) {
  plant();
  const Plant& p = GetParam();
  Words words = {"render", p.scene, "--use", std::string(p.unit) + "=mine.sv", "--crc"};
  if (p.scene == std::string("demo")) words.insert(words.end(), {"--first", "7223"});
  Program run(folder.path(), words);
  EXPECT_EQ(run.wait(), 2) << run.err();
  const std::string said = run.err();
  EXPECT_THAT(said, HasSubstr("the chip makes no progress: "));
  EXPECT_THAT(said, HasSubstr(std::string(p.unit) + " waits for nobody"));
  EXPECT_THAT(said, Not(HasSubstr("internal error")));
}

const Plant plants[] = {
    {"VgaTimingStopsInALine", "vga_timing", "h_pos_q <= h_pos_d;",
     "h_pos_q <= v_pos_q == -10'sd200 && h_pos_q == 7 ? h_pos_q : h_pos_d;", "demo", "video"},
    {"CameraUnitNeverRuns", "camera_unit", "Load: phase_d = Scale;",
     "Load: if ($signed(y_i) < -10'sd250) phase_d = Scale;"},
    {"SubdividerNeverEndsItsWalk", "subdivider", "if (idx_load_i) idx2_d = idx_start_i;",
     "if (idx_load_i) idx2_d = idx_start_i;\n    else if (tracer_reset_i) idx2_d = idx2_q;"},
    {"SubdividerNeverHits", "subdivider", "wire logic hit_now = accept && (wall_i || hurry);",
     "wire logic hit_now = accept && (wall_i || hurry) && len_m1 > 10'd700;"},
    {"SubdividerForgetsToOffer", "subdivider",
     "wire logic emit = returning && !emit_done_q && !line_done_q;",
     "wire logic emit = returning && !emit_done_q && !line_done_q && i1_q == '1;"},
    {"StacksGiveAnotherPlace", "stacks", "top_tag_o = racebeam_pkg::TagPortBits'(tags_q[n]);",
     "top_tag_o = racebeam_pkg::TagPortBits'({tags_q[n][6:3], 3'd5});"},
    {"DecisionDatapathIsHalfWayForEver", "decision_datapath", "second_q <= second_d;",
     "second_q <= second_d || second_q && !root;"},
    {"DecisionDatapathDoesNotClimb", "decision_datapath", "level_q <= level_d;",
     "if (!climb_i || root) level_q <= level_d;"},
    {"DecisionDatapathMeetsNoWall", "decision_datapath", "wall_q <= wall_d;",
     "wall_q <= 1'b0 & wall_d;"},
    {"IntervalFifoTakesNothingOnceItWasFull", "interval_fifo",
     "wire logic listen = ~eat_head & ~split & emit_i;",
     "logic dead_q;\n  always_ff @(posedge clk_i) dead_q <= dead_q | full;\n"
     "  wire logic listen = ~eat_head & ~split & emit_i & ~dead_q;"},
    {"IntervalFifoAnswersNobody", "interval_fifo", "assign ack_o = merge | take;",
     "assign ack_o = merge | take | 1'b1;"},
    {"WriteBufferNeverTakesAgain", "write_buffer",
     "assign put_ready_o = WhenFull == 1 || !full_q || take_ready_i;",
     "assign put_ready_o = head_q == '0;", Voxel, "store"},
    {"StoreArbiterRefuses", "store_arbiter",
     "assign take_ready_o = ", "assign take_ready_o = 1'b0 && ", Voxel, "store"},
    {"VoxelScanAsksForNoColour", "voxel_scan", "assign shade_o = ray_done_i && ",
     "assign shade_o = ray_done_i && column_q < PlaceBits'(20) && ", Voxel, "voxel"},
    {"BlockSchedulerDealsNothing", "block_scheduler",
     "wire logic [Cores-1:0] ready = job_ready_i[Cores-1:0];",
     "wire logic [Cores-1:0] ready = x_q == '0 ? job_ready_i[Cores-1:0] : '0;", Block, "block"},
    {"BlockBusServesNobody", "block_bus", "wire logic [Cores-1:0] asks = word_valid_i[Cores-1:0];",
     "wire logic [Cores-1:0] asks = later_q == '0 ? word_valid_i[Cores-1:0] : '0;", Block, "block"},
};
INSTANTIATE_TEST_SUITE_P(Plants, CliHangTest, testing::ValuesIn(plants),
                         [](const auto& plant) { return plant.param.name; });

// RTL that is right, which may starve, restart and wait as it likes.
void expect_no_alarm(const Words& more) {
  const ScratchFolder folder;
  Words words = {"render", "demo", "--use", "interval_fifo=rtl", "--crc", "--json", "-o", "out"};
  words.insert(words.end(), more.begin(), more.end());
  Program run(folder.path(), words);
  EXPECT_EQ(run.wait(), 0) << run.err();
}
TEST(NoAlarm, InTheFramesThatStarveMostAndWithTheLockEffect) {
  expect_no_alarm({"--at", "2600,4860,7140"});
}
TEST(NoAlarm, InAChipThatHardlyEverEndsALine) {
  expect_no_alarm(
      {"--at", "7140", "--set", "clocks_per_pixel=1", "--set", "interval_stack_depth=1"});
}
TEST(NoAlarm, WithStallsMostOfTheTime) {
  expect_no_alarm({"--at", "7140", "--shake", "1,0.3,0.99"});
}
TEST(LongNoAlarm, In128FramesOfTheDemo) { expect_no_alarm({"--frames", "128", "--every", "99"}); }

}  // namespace
}  // namespace racebeam
