// Promises of `--use`: whatever units are RTL, the chip's pins and counters are those of its cores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "sc/beam/units.h"
#include "tb/bench/core_bench.h"
#include "tb/bench/signal_bench.h"
#include "tb/twin/beam_twins.h"
#include "tests/support/expect_stats.h"

namespace racebeam {
namespace {

constexpr int Crowded = 7223;  // heights of the open grid
constexpr int Flight = 3900;   // through portals, with an effect
const int Units = static_cast<int>(chip_units(false).size());

/// Compares the chip with the RTL of the units whose bit is set.
void expect_the_chip(unsigned rtl_units, int frame, const knobs& k = {}) {
  unit_choices choices;
  std::string names;
  for (int n = 0; n < Units; ++n)
    if (rtl_units >> n & 1) {
      choices.by_unit[chip_units(false)[n]] = {unit_choice::Rtl, false,
                                               beam_plugins(k).own(chip_units(false)[n])};
      names += chip_units(false)[n] + " ";
    }
  SCOPED_TRACE("frame " + std::to_string(frame) + ", RTL: " + names);
  SignalBench bench({k, true, true, false, nullptr, choices});
  bench.seek(frame);
  const auto got = bench.render();
  const auto expected = CoreBench(k, frame).render();
  EXPECT_EQ(got.picture.pins_crc, expected.pins_crc);
  expect_equal(*got.stats, expected.stats);
}

class ChipMix : public testing::TestWithParam<int> {};

using OneUnit = ChipMix;
using LongOneUnit = ChipMix;
TEST_P(OneUnit, AsRtlGivesThePinsAndCountersOfTheCores) {
  expect_the_chip(1u << GetParam(), Crowded);
}
TEST_P(LongOneUnit, AsModelAmongRtlGivesThePinsAndCountersOfTheCores) {
  expect_the_chip(~(1u << GetParam()), Flight);
}
std::string unit_name(const testing::TestParamInfo<int>& unit) {
  return chip_units(false)[static_cast<std::size_t>(unit.param)];
}
INSTANTIATE_TEST_SUITE_P(Units, OneUnit, testing::Range(0, Units), unit_name);
INSTANTIATE_TEST_SUITE_P(LongUnits, LongOneUnit, testing::Range(0, Units), unit_name);

using RandomMix = ChipMix;
TEST_P(RandomMix, GivesThePinsAndCountersOfTheCores) {
  std::minstd_rand random(static_cast<unsigned>(GetParam()));
  random.discard(10);
  expect_the_chip(random() >> 8, GetParam() % 2 ? Crowded : Flight);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomMix, testing::Range(1, 9));
INSTANTIATE_TEST_SUITE_P(LongSeeds, RandomMix, testing::Range(9, 51));

TEST(AllRtl, GivesThePinsAndCountersOfTheCores) { expect_the_chip(~0u, Crowded); }

// Knobs whose bits cross ports of their own.
TEST(AllRtl, GivesThePinsAndCountersOfTheCoresWithEdgesFromTheSceneAndCheckers) {
  constexpr int Dithered = 5119;
  knobs k;
  k.skip_shared_edges = SharedEdgesTable;
  k.dithering = DitheringCheckered;
  expect_the_chip(~0u, Dithered, k);
}

}  // namespace
}  // namespace racebeam
