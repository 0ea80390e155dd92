// The RTL is the same chip for yosys as it is for Verilator.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/netlist_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class NetlistOfWords : public NetlistTest {};
class NetlistOfGates : public NetlistTest {};

TEST_P(NetlistOfWords, IsTheModel) { expect_equal(GetParam(), {}); }
TEST_P(NetlistOfGates, IsTheModel) { expect_equal(GetParam(), {"--gates"}); }

INSTANTIATE_TEST_SUITE_P(Units, NetlistOfWords,
                         testing::Values("vga_timing", "sequencer", "timeline", "camera_unit",
                                         "ray_stepper", "subdivider", "stacks", "decision_datapath",
                                         "scene", "scene_rom", "navigator", "interval_fifo",
                                         "pixel_output", "pwm_sound"),
                         unit_of);
// With all signals to be read: a minute for the compiler.
INSTANTIATE_TEST_SUITE_P(LongUnits, NetlistOfWords, testing::Values("racebeam_top"), unit_of);
// The others are in netlist_gates_test.cpp, as they take minutes.
INSTANTIATE_TEST_SUITE_P(Units, NetlistOfGates,
                         testing::Values("vga_timing", "sequencer", "timeline", "camera_unit",
                                         "stacks", "scene", "scene_rom", "navigator",
                                         "interval_fifo", "pixel_output"),
                         unit_of);

// As rtl/beam/scene.sv had it: yosys takes -N'(x) for (-N)'(x), and the windows move.
TEST_F(NetlistTest, AMinusThatYosysDropsIsFound) {
  std::string text = read_file(RACEBEAM_SOURCE_DIR "/rtl/beam/scene.sv");
  const std::string good = "-(CornerBits'(272))";
  const auto at = text.find(good);
  ASSERT_NE(at, std::string::npos);
  std::ofstream(folder / "old.sv") << text.replace(at, good.size(), "-CornerBits'(272)");
  make("scene=old.sv");
  Program run(folder.path(), verify("scene"));
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.err(), HasSubstr("scene: port position_y_o differs"));
}

TEST_F(NetlistTest, HasTheValuesOfItsParameters) {
  make("stacks", {}, {"IntervalStackDepth=2"});
  Program same(folder.path(), verify("stacks", {"--set", "interval_stack_depth=2"}));
  EXPECT_EQ(same.wait(), 0) << same.err();
  Program other(folder.path(), verify("stacks"));
  EXPECT_EQ(other.wait(), 1);
}

TEST_F(NetlistTest, WhatCannotBeMadeIsTold) {
  const auto ends = [&](const std::string& words) {
    const std::string command = "cd '" + folder.path() +
                                "' && '" RACEBEAM_SOURCE_DIR "/scripts/netlist' " + words +
                                " 2>said";
    const int code = WEXITSTATUS(std::system(command.c_str()));
    EXPECT_FALSE(std::filesystem::exists(folder / "netlist.v"));
    return std::to_string(code) + " " + read_file(folder / "said");
  };
  EXPECT_THAT(ends(""), HasSubstr("2 scripts/netlist: it takes [--gates] UNIT"));
  EXPECT_THAT(ends("stakcs netlist.v"), HasSubstr("stakcs.sv"));
  EXPECT_THAT(ends("stacks netlist.v Depth=2"), HasSubstr("`Depth`"));
  std::ofstream(folder / "bad.sv") << "module stacks; endmodul";
  EXPECT_THAT(ends("stacks=bad.sv netlist.v"), HasSubstr("syntax error"));
}

}  // namespace
}  // namespace racebeam
