// The large units and the whole chip as gates: minutes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/netlist_bench.h"

namespace racebeam {
namespace {

class NetlistOfManyGates : public NetlistTest {};

TEST_P(NetlistOfManyGates, IsTheModel) { expect_equal(GetParam(), {"--gates"}); }

INSTANTIATE_TEST_SUITE_P(Units, NetlistOfManyGates,
                         testing::Values("ray_stepper", "subdivider", "decision_datapath",
                                         "pwm_sound", "racebeam_top"),
                         unit_of);

TEST_F(NetlistTest, GatesBehindTinyTapeoutPinsAreTheTapedOutChip) {
  make("tt_um_racebeam", {"--gates"});
  std::ofstream(folder / "info.yaml") << "project:\n  top_module: tt_um_racebeam\n"
                                         "  clock_hz: 50400000\n  source_files: [netlist.v]\n";
  Program run(folder.path(),
              {"render", "--tt", folder.path(), "--frames", "2", "--against", "demo"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.out(), testing::HasSubstr("2 of 2 frames equal the taped-out chip's"));
}

}  // namespace
}  // namespace racebeam
