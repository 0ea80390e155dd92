// What technologies say of whole chips, and what becomes of tools that say nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/chip_mapping.h"

#include <gmock/gmock.h>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "sc/beam/silicon.h"
#include "sc/sphere/engine.h"
#include "tb/base/errors.h"
#include "tests/support/fake_mapping.h"
#include "tests/support/fake_yosys.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

ChipWanted chip_of(const knobs& k, const char* technology) {
  const Silicon silicon(beam_engine());
  return Technology(silicon, technology).chip_of(k);
}

ChipOutcome outcome_of(const ChipWanted& wanted, std::chrono::milliseconds limit = ChipLimit) {
  ChipOutcome outcome;
  map_chips({wanted}, {1, limit, {}},
            [&](const ChipWanted&, const ChipOutcome& end) { outcome = end; });
  return outcome;
}

std::string fault_of_chip(const char* technology) {
  const ChipOutcome outcome = outcome_of(chip_of(knobs(), technology));
  EXPECT_FALSE(outcome.mapped);
  return outcome.fault;
}

TEST(ChipMapping, FiguresAreReadFromTheToolsOfEachTechnology) {
  const FakeYosys yosys(MapsAChip);
  const FakeTool sta("sta", FindsAPath), nextpnr("nextpnr-ice40", Routes);
  const ChipOutcome cells = outcome_of(chip_of(knobs(), StandardCells));
  ASSERT_TRUE(cells.mapped) << cells.fault;
  EXPECT_EQ(cells.mapped->flip_flops, 2);
  EXPECT_EQ(cells.mapped->cells, 5);
  EXPECT_EQ(cells.mapped->area, 96);
  EXPECT_EQ(cells.mapped->multipliers, 2 * 96) << "two of them";
  EXPECT_EQ(cells.mapped->ns, 22.5);
  EXPECT_EQ(cells.mapped->from, "u_a.one_q[1]");
  EXPECT_EQ(cells.mapped->to, "u_b.two_q");
  const ChipOutcome fpga = outcome_of(chip_of(knobs(), Fpga));
  ASSERT_TRUE(fpga.mapped) << fpga.fault;
  EXPECT_EQ(fpga.mapped->cells, 3) << "LUTs";
  EXPECT_FALSE(fpga.mapped->area);
  EXPECT_EQ(fpga.mapped->ns, 80);
  EXPECT_EQ(fpga.mapped->from, "u_a.one_q[1]");
  EXPECT_EQ(fpga.mapped->to, "u_b.two_q");
}

// The real sta ends with 0 after an error: the path that is not there is the fault.
TEST(ChipMapping, StaThatCannotReadTheNetlistIsAFault) {
  const FakeYosys yosys(std::string(MapsAChip) + "echo 'module broken {' >out\n");
  EXPECT_THAT(fault_of_chip(StandardCells),
              AllOf(StartsWith("racebeam_top in osu018: "), HasSubstr("syntax error")));
}

TEST(ChipMapping, AChipWithoutAPathIsAFault) {
  const FakeYosys yosys(MapsAChip);  // no cell is in the netlist
  EXPECT_THAT(fault_of_chip(StandardCells), HasSubstr("sta has not found the WORST path"));
  const FakeTool nextpnr("nextpnr-ice40",
                         std::string(Routes) + "echo '{\"critical_paths\": []}' >$report\n");
  EXPECT_THAT(fault_of_chip(Fpga), HasSubstr("nextpnr has not told the longest path"));
}

TEST(ChipMapping, AChipThatDoesNotFitIsAFault) {
  const FakeYosys yosys(MapsAChip);
  const FakeTool nextpnr("nextpnr-ice40",
                         "[ $1 = -V ] && exit\necho 'ERROR: no room for the LUTs'\nexit 1\n");
  EXPECT_EQ(fault_of_chip(Fpga), "racebeam_top in ice40: ERROR: no room for the LUTs");
}

TEST(ChipMapping, WhatHangsIsEndedByItsLimit) {
  const FakeYosys yosys(FakeYosys::Hangs);
  knobs k;
  k.fifo_entries = 12;
  const ChipWanted wanted = chip_of(k, StandardCells);
  ChipOutcome outcome;
  do outcome = outcome_of(wanted, std::chrono::milliseconds(1500));
  while (!yosys.hangs());  // a busy machine had not begun in time
  EXPECT_EQ(outcome.fault,
            "racebeam_top with FifoEntries=12 in osu018: scripts/timing did not end within 1.5 "
            "seconds");
  EXPECT_TRUE(yosys.is_gone());
}

TEST(ChipMapping, AToolThatIsMissingIsNamed) {
  const ScratchFolder folder;  // all that there is but sta
  for (const char* from : {"/usr/bin", "/bin"})
    for (const auto& one : std::filesystem::directory_iterator(from)) {
      std::error_code there_already;
      if (one.path().filename() != "sta")
        std::filesystem::create_symlink(one.path(), folder / one.path().filename().string(),
                                        there_already);
    }
  setenv("PATH", folder.path().c_str(), 1);
  EXPECT_THAT(error_of([] { chip_of(knobs(), StandardCells); }),
              HasSubstr("sta is not installed; scripts/setup more installs it"));
  EXPECT_THROW(chip_of(knobs(), StandardCells), MissingTool);
}

TEST(ChipMapping, TheKeyIsOfKnobsAndTechnologyAndNotOfPins) {
  knobs other, pins;
  other.partial_products_cut = 4;
  pins.speed = 3;
  const std::string hash = chip_of(knobs(), StandardCells).chip.hash;
  EXPECT_EQ(chip_of(pins, StandardCells).chip.hash, hash);
  EXPECT_NE(chip_of(other, StandardCells).chip.hash, hash);
  EXPECT_NE(chip_of(knobs(), Fpga).chip.hash, hash);
  const FakeTool sta("sta", FindsAPath);
  EXPECT_NE(chip_of(knobs(), StandardCells).chip.hash, hash) << "another version";
}

TEST(ChipMapping, AnEngineWithoutSuchAChipAndAKnobThatItHasNotAreSaid) {
  const Silicon spheres(sphere_engine());
  EXPECT_THAT(error_of([&] { spheres.chip_of(sphere_engine().standard(nullptr)); }),
              HasSubstr("has no RTL of a whole chip"));
  knobs exact;
  exact.camera_cosine = 1;  // of the model only
  const Silicon silicon(beam_engine());
  EXPECT_THROW(silicon.chip_of(exact), NoSilicon);
}

TEST(ChipMapping, TilesAreAnEstimateFromGates) {
  // 266,326 / 24 NAND gates of 3.7536 square micrometres in 10,772.8 of a tile
  EXPECT_NEAR(estimated_tiles(266326), 3.866, 0.001);
}

TEST(ModelSilicon, PartialProductsAreThoseThatAreKept) {
  knobs k;
  EXPECT_EQ(beam_silicon(k, nullptr).partial_products(), 2u * (9 * 8 - 15));
  k.partial_products_cut = 0;
  EXPECT_EQ(beam_silicon(k, nullptr).partial_products(), 2u * 9 * 8);
  k.dr_bits = 11;
  k.corner_factor_bits = 6;
  EXPECT_EQ(beam_silicon(k, nullptr).partial_products(), 2u * 10 * 6);
}

// 17 bits an entry of the interval stack; a FIFO's entry has 6 of length and 2 of colour.
TEST(ModelSilicon, RegistersFollowTheKnobs) {
  knobs k;
  const std::uint64_t usual = beam_silicon(k, nullptr).register_bits;
  k.interval_stack_depth = 6;
  k.fifo_entries = 13;
  EXPECT_GE(beam_silicon(k, nullptr).register_bits, usual + 2 * 17 + 3 * 8);
  EXPECT_LE(beam_silicon(k, nullptr).register_bits, usual + 2 * 17 + 3 * 8 + 4) << "pointers";
}

TEST(LongChipMapping, TheChipIsMappedAndACutSavesArea) {
  knobs cut;
  cut.partial_products_cut = 8;
  const ChipOutcome chip = outcome_of(chip_of(knobs(), StandardCells)),
                    less = outcome_of(chip_of(cut, StandardCells));
  ASSERT_TRUE(chip.mapped) << chip.fault;
  ASSERT_TRUE(less.mapped) << less.fault;
  // constant bits of decision_datapath's portals are no flip-flops
  EXPECT_NEAR(double(chip.mapped->flip_flops), double(beam_silicon(knobs(), nullptr).register_bits),
              15);
  EXPECT_LT(*less.mapped->area, *chip.mapped->area);
  EXPECT_LT(*less.mapped->multipliers, *chip.mapped->multipliers);
  EXPECT_GT(*chip.mapped->multipliers, 0.05 * *chip.mapped->area);
  EXPECT_LT(*chip.mapped->multipliers, 0.5 * *chip.mapped->area);
  EXPECT_GT(chip.mapped->ns, 15);
  EXPECT_LT(chip.mapped->ns, 30);
  EXPECT_THAT(chip.mapped->from, testing::MatchesRegex("u_[a-z_]+\\..*_q.*"));
  EXPECT_THAT(chip.mapped->to, testing::MatchesRegex("u_[a-z_]+\\..*_q.*"));
}

TEST(LongChipMapping, TheFpgaHasAPathFromRegisterToRegister) {
  const ChipOutcome chip = outcome_of(chip_of(knobs(), Fpga));
  ASSERT_TRUE(chip.mapped) << chip.fault;
  EXPECT_GT(chip.mapped->cells, 1500);
  EXPECT_LT(chip.mapped->cells, 7680) << "LUTs of the FPGA";
  EXPECT_GT(chip.mapped->ns, 40);
  EXPECT_LT(chip.mapped->ns, 160);
  EXPECT_THAT(chip.mapped->from, testing::MatchesRegex("u_[a-z_]+\\..*_q.*"));
  EXPECT_THAT(chip.mapped->to, testing::MatchesRegex("u_[a-z_]+\\..*_q.*"));
}

}  // namespace
}  // namespace racebeam
