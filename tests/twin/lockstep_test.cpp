// The comparison of model and RTL tells every wrong bit, at its clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep.h"

#include <gtest/gtest.h>

#include <random>

#include "sc/base/unit_choices.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/stacks.h"
#include "sc/beam/units.h"
#include "tb/scene/scene_compiler.h"
#include "tb/scene/scene_reader.h"
#include "tb/twin/beam_twins.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {
namespace {

class LockstepTest : public testing::Test {
 protected:
  void run(std::uint64_t clocks) {
    bench.between_edges([this] { traffic.next(); });
    bench.clock(static_cast<int>(clocks));
  }

  stacks model{"model", knobs{}};
  Lockstep lockstep{"lockstep", "stacks", model, knob_parameters({}),
                    beam_plugins({}).own("stacks")};
  UnitBench bench{model, &lockstep.clk_i};
  RandomTraffic traffic{bench, beam_inputs({}), 7};
};

TEST_F(LockstepTest, ModelAndRtlOfStacksAgreeOnRandomTraffic) {
  run(20000);
  EXPECT_EQ(lockstep.clocks(), 20000u);
  EXPECT_EQ(lockstep.differences(), 0u);
  EXPECT_FALSE(lockstep.first());
}

TEST_F(LockstepTest, KeepsTheClocksBeforeADifference) {
  lockstep.invert("top_i2_o", 9, 1234);
  run(2000);
  EXPECT_EQ(lockstep.differences(), 1u);
  ASSERT_TRUE(lockstep.first());
  const LockstepDifference& first = *lockstep.first();
  EXPECT_EQ(first.unit, "stacks");
  EXPECT_EQ(first.before, std::size_t{LockstepDifference::Before});
  EXPECT_EQ(first.first_clock(), 1234u - LockstepDifference::Before);
  EXPECT_TRUE(first.whole());
  EXPECT_EQ(first.history.back().size(), first.columns.size());
}

TEST_F(LockstepTest, RefusesOutputsThatTheRtlDoesNotHave) {
  EXPECT_THROW(lockstep.invert("sp_o", 0, 1), RtlError);
}

class EveryUnit : public testing::TestWithParam<std::string> {};

TEST_P(EveryUnit, TellsEveryInvertedOutputBitAndItsClock) {
  constexpr int Clocks = 100;  // for each bit
  const scene_program program =
      compile_scene(read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/demo.toml").scene);
  const bool of_scene_files = unit_named(GetParam()).shows == unit_row::SceneFile;
  const knobs k = of_scene_files ? program.fitted({}) : knobs{};
  const auto model = unit_named(GetParam()).make("model", k, &program);
  const PluginMaker maker = beam_plugins(k, of_scene_files ? &program : nullptr);
  Lockstep lockstep("lockstep", GetParam(), *model, knob_parameters(k), maker.own(GetParam()));
  UnitBench bench(*model, &lockstep.clk_i);
  RandomTraffic traffic(bench, beam_inputs(k), 5);
  bench.between_edges([&] { traffic.next(); });
  bench.clock(Clocks);
  std::mt19937 random(3);
  for (const UnitBench::Pin* pin : bench.pins())
    for (int bit = 0; bit < pin->bits && !pin->input; ++bit) {
      const std::uint64_t clock = lockstep.clocks() + random() % Clocks;
      lockstep.invert(pin->name, bit, clock);
      bench.clock(Clocks);
      ASSERT_TRUE(lockstep.first()) << pin->name << " bit " << bit;
      EXPECT_EQ(lockstep.first()->port, pin->name);
      EXPECT_EQ(lockstep.first()->clock, clock);
      EXPECT_EQ(lockstep.first()->expected ^ lockstep.first()->got, 1 << bit);
    }
}

std::vector<std::string> all_units() {
  std::vector<std::string> units;
  for (const unit_row& row : unit_table()) units.push_back(row.name);
  return units;
}

INSTANTIATE_TEST_SUITE_P(Units, EveryUnit, testing::ValuesIn(all_units()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace racebeam
