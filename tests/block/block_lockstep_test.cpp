// The RTL of the block renderer's units beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sc/block/block_lane.h"
#include "sc/block/block_normalise.h"
#include "sc/block/block_pack.h"
#include "sc/block/block_parameters.h"
#include "sc/block/block_root.h"
#include "sc/block/block_shade.h"
#include "sc/block/block_spheres.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {
namespace {

using Module = std::unique_ptr<sc_core::sc_module>;

struct Pair {
  std::string unit, name;
  Module (*make)(const block_knobs& k);
  block_knobs k;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.unit << ", " << pair.name; }

template <class Unit>
Module with_knobs(const block_knobs& k) {
  return std::make_unique<Unit>("model", k);
}
template <class Unit>
Module without_knobs(const block_knobs&) {
  return std::make_unique<Unit>("model");
}

std::vector<Pair> pairs() {
  return {{"block_root", "default", without_knobs<block_root>, {}},
          {"block_lane", "default", without_knobs<block_lane>, {}},
          {"block_pack", "default", without_knobs<block_pack>, {}},
          {"block_normalise", "default", with_knobs<block_normalise>, {}},
          {"block_normalise", "no_steps", with_knobs<block_normalise>, {4, 0, 4}},
          {"block_normalise", "three_steps", with_knobs<block_normalise>, {4, 3, 4}},
          {"block_shade", "default", with_knobs<block_shade>, {}},
          {"block_shade", "no_squarings", with_knobs<block_shade>, {4, 2, 0}},
          {"block_shade", "six_squarings", with_knobs<block_shade>, {4, 2, 6}},
          {"block_spheres", "default", with_knobs<block_spheres>, {}},
          {"block_spheres", "one_lane", with_knobs<block_spheres>, {1, 2, 4}},
          {"block_spheres", "eight_lanes", with_knobs<block_spheres>, {8, 2, 4}}};
}

class BlockLockstep : public testing::TestWithParam<Pair> {
 protected:
  void agrees_in_random_traffic(int clocks) {
    constexpr unsigned Seed = 1;
    const Pair& pair = GetParam();
    const Module unit = pair.make(pair.k);
    Lockstep lockstep("lockstep", pair.unit, *unit, block_parameters(pair.k),
                      PluginMaker(block_parameters(pair.k)).own(pair.unit));
    UnitBench bench(*unit, &lockstep.clk_i);
    RandomTraffic traffic(bench, LegalInputs({}), Seed);
    bench.between_edges([&] { traffic.next(); });
    bench.clock(clocks);
    EXPECT_GE(lockstep.clocks(), static_cast<std::uint64_t>(clocks));
    EXPECT_EQ(lockstep.differences(), 0u)
        << "seed " << Seed << "\n"
        << (lockstep.first() ? difference_table(*lockstep.first()) : "");
  }
};
std::string name_of(const testing::TestParamInfo<Pair>& info) {
  return info.param.unit + "_" + info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Pairs, BlockLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(BlockLockstep, AgreesInRandomTraffic) { agrees_in_random_traffic(20'000); }

using LongBlockLockstep = BlockLockstep;
INSTANTIATE_TEST_SUITE_P(LongPairs, LongBlockLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(LongBlockLockstep, AgreesInLongRandomTraffic) { agrees_in_random_traffic(1'000'000); }

}  // namespace
}  // namespace racebeam
