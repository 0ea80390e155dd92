// The wired sphere tracer with RTL in the place of its units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "sc/sphere/sphere_parameters.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/sphere_twins.h"
#include "tests/sphere/chip_and_core.h"
#include "tests/sphere/own_units.h"

namespace racebeam {
namespace {

constexpr int Size512 = 1 << 5, Sub4x = 1 << 0, Reflections3 = 3 << 2, NoKey = 15,
              PlanesKey = 15 & ~4;

unit_choices rtl_of(const std::vector<std::string>& units) {
  const PluginMaker plugins = sphere_plugins({}, four_tables());
  unit_choices choices;
  for (const std::string& unit : units)
    choices.by_unit[unit] = {unit_choice::Rtl, false, plugins.own(unit)};
  return choices;
}

void expect_picture(const std::vector<std::string>& units, const sphere_board& board) {
  ChipAndCore both({}, board, rtl_of(units));
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

TEST(SphereChipRtl, AllUnitsDrawTheCoresPicture) { expect_picture(sphere_units(), {0, NoKey}); }

TEST(LongSphereChipRtl, AllUnitsDrawTheCoresPlanes) {
  expect_picture(sphere_units(), {Size512 | Reflections3, PlanesKey});
}

class OneUnitRtl : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(LongUnits, OneUnitRtl, testing::ValuesIn(sphere_units()),
                         [](const auto& info) { return info.param; });

TEST_P(OneUnitRtl, DrawsTheCoresPicture) {
  expect_picture({GetParam()}, {Size512 | Reflections3, NoKey});
}

/// The RTL of every unit beside its model in the chip.
class AllBeside : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};

  AllBeside(const sc_core::sc_module_name& name, const sphere_chip& chip, const sphere_knobs& k,
            const sphere_tables& tables)
      : sc_module(name) {
    const PluginMaker plugins = sphere_plugins(k, tables);
    for (sc_core::sc_object* child : chip.get_child_objects()) {
      const auto* unit = dynamic_cast<const sc_core::sc_module*>(child);
      const std::string name = child->basename();
      if (!unit || name == "u_frame_memory") continue;
      units.push_back(name.substr(2));
      locksteps.push_back(std::make_unique<Lockstep>(name.c_str(), units.back(), *unit,
                                                     sphere_parameters(k, tables),
                                                     plugins.own(units.back())));
      locksteps.back()->clk_i(clk_i);
    }
  }

  std::vector<std::string> units;
  std::vector<std::unique_ptr<Lockstep>> locksteps;
};

void expect_agreement(const sphere_knobs& k, const sphere_board& board, int clocks) {
  sphere_tables tables = four_tables();
  tables.start.origin[1] = 12 * 4096;  // the upper rows show spheres
  sphere_chip chip("sphere", k, tables);
  AllBeside beside("beside", chip, k, tables);
  UnitBench bench(chip, &beside.clk_i);
  bench["sw_i"].drive(static_cast<unsigned>(board.sw));
  bench["key_ni"].drive(static_cast<unsigned>(board.key_n));
  bench.clock(2);
  bench["rst_ni"].drive(1);
  bench.settle();
  send_four(bench, [&bench] { bench.clock(); });
  bench.clock(clocks);
  EXPECT_EQ(bench["done_o"].value(), 0u);
  EXPECT_THAT(beside.units, testing::UnorderedElementsAreArray(sphere_units()));
  for (const auto& lockstep : beside.locksteps) {
    EXPECT_GE(lockstep->clocks(), static_cast<std::uint64_t>(clocks));
    EXPECT_EQ(lockstep->differences(), 0u)
        << (lockstep->first() ? difference_table(*lockstep->first()) : "");
  }
}

TEST(SphereChipRtl, EveryUnitAgreesInTheChip) {
  expect_agreement({}, {Reflections3 | Sub4x, PlanesKey}, 200'000);
}

TEST(SphereChipRtl, EveryUnitAgreesWithOtherKnobs) {
  sphere_knobs k;
  k.fraction_bits = 8;
  k.colour_bits = 8;
  k.root_bits_per_clock = 3;
  k.divide_clocks = 9;
  k.table_entries = 5;
  k.write_buffer_depth = 8;
  k.write_policy = WritePolicyBlanking;
  k.write_each_pass = 1;
  k.plane_shadows = 1;
  k.min_weight = 1000;
  k.wide = 1;
  k.clocks_per_pixel = 2;
  expect_agreement(k, {Size512 | Reflections3, PlanesKey}, 200'000);
}

}  // namespace
}  // namespace racebeam
