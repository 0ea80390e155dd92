// The wired block renderer with RTL in the place of its units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "sc/block/block_parameters.h"
#include "sc/block/engine.h"
#include "tb/twin/block_twins.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tests/block/chip_and_machine.h"
#include "tests/block/few_spheres.h"
#include "tests/support/block_scenes.h"

namespace racebeam {
namespace {

const std::vector<std::string>& block_units() {
  static const std::vector<std::string> units = block_engine().unit_names(false);
  return units;
}

unit_choices rtl_of(const std::vector<std::string>& units, const block_knobs& k) {
  const PluginMaker plugins = block_plugins(k);
  unit_choices choices;
  for (const std::string& unit : units)
    choices.by_unit[unit] = {unit_choice::Rtl, false, plugins.own(unit)};
  return choices;
}

void expect_picture(const std::vector<std::string>& units, const block_knobs& k,
                    const block_tables& tables) {
  ChipAndMachine both(k, tables, rtl_of(units, k));
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

block_knobs with_cores(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

TEST(BlockChipRtl, HasTheUnitsThatThereAre) {
  EXPECT_THAT(block_units(),
              testing::ElementsAre("block_convert", "block_scheduler", "block_core", "block_bus",
                                   "write_buffer", "store_arbiter", "vga_timing", "frame_scanout"));
}

TEST(BlockChipRtl, AllUnitsDrawTheMachinesPicture) {
  expect_picture(block_units(), with_cores(3), few_tables());
}

TEST(LongBlockChipRtl, AllUnitsDrawQuad) {
  expect_picture(block_units(), with_cores(4), quad_tables());
}

class OneUnitRtl : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(LongUnits, OneUnitRtl, testing::ValuesIn(block_units()),
                         [](const auto& info) { return info.param; });

TEST_P(OneUnitRtl, DrawsTheMachinesPicture) {
  expect_picture({GetParam()}, with_cores(4), few_tables());
}

/// The RTL of every unit beside its model in the chip; of all cores.
class AllBeside : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};

  AllBeside(const sc_core::sc_module_name& name, const block_chip& chip, const block_knobs& k)
      : sc_module(name) {
    const PluginMaker plugins = block_plugins(k);
    for (const sc_core::sc_module* module : chip.modules()) {
      const std::string instance = module->basename();
      if (instance.rfind("u_", 0) != 0 || instance == "u_frame_memory") continue;
      const std::string unit = instance.substr(2);
      units.push_back(unit);
      locksteps.push_back(std::make_unique<Lockstep>(sc_core::sc_gen_unique_name(unit.c_str()),
                                                     unit, *module, block_parameters(k),
                                                     plugins.own(unit)));
      locksteps.back()->clk_i(clk_i);
    }
  }

  std::vector<std::string> units;
  std::vector<std::unique_ptr<Lockstep>> locksteps;
};

void expect_agreement(const block_knobs& k) {
  block_chip chip("block", k);
  AllBeside beside("beside", chip, k);
  UnitBench bench(chip, &beside.clk_i);
  SceneSender sender(bench, quad_tables(), k);
  sender.send([&] { bench.clock(); });
  bench.clock(100'000);
  EXPECT_EQ(bench["done_o"].value(), 0u);
  EXPECT_EQ(beside.units.size(), block_units().size() - 1 + static_cast<std::size_t>(k.cores));
  for (const std::string& unit : block_units()) EXPECT_THAT(beside.units, testing::Contains(unit));
  for (const auto& lockstep : beside.locksteps) {
    EXPECT_GE(lockstep->clocks(), 100'000u);
    EXPECT_EQ(lockstep->differences(), 0u)
        << (lockstep->first() ? difference_table(*lockstep->first()) : "");
  }
}

TEST(BlockChipRtl, EveryUnitAgreesInTheChip) { expect_agreement(with_cores(2)); }

TEST(BlockChipRtl, EveryUnitAgreesWithOtherKnobs) {
  block_knobs k = with_cores(3);
  k.lanes = 2;
  k.newton_steps = 1;
  k.specular_squarings = 2;
  k.max_passes = 2;
  k.cull = BlockCullOff;
  k.root = BlockRootExact;
  k.background = 0x123456;
  k.fraction_bits = 14;
  k.size = BlockSize512;
  k.write_buffer_depth = 8;
  k.write_policy = WritePolicyBlanking;
  k.when_full = WhenFullDrop;
  expect_agreement(k);
}

}  // namespace
}  // namespace racebeam
