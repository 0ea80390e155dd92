// The RTL of the block renderer's units beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sc/block/block_bus.h"
#include "sc/block/block_convert.h"
#include "sc/block/block_core.h"
#include "sc/block/block_lane.h"
#include "sc/block/block_normalise.h"
#include "sc/block/block_pack.h"
#include "sc/block/block_parameters.h"
#include "sc/block/block_root.h"
#include "sc/block/block_scheduler.h"
#include "sc/block/block_shade.h"
#include "sc/block/block_spheres.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {
namespace {

/// Names of the settings.
const char* const Counts[] = {"none", "one", "two",   "three", "four",
                              "five", "six", "seven", "eight", "all"};

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

template <class Set>
block_knobs with(const Set& set) {
  block_knobs k;
  set(k);
  return k;
}

std::vector<Pair> pairs() {
  std::vector<Pair> all = {{"block_lane", "default", without_knobs<block_lane>, {}},
                           {"block_pack", "default", without_knobs<block_pack>, {}}};
  const auto add = [&all](const char* unit, Module (*make)(const block_knobs&), const char* name,
                          const block_knobs& k) {
    all.push_back({unit, name, make, k});
  };
  for (const int root : {BlockRootTrick, BlockRootHeron, BlockRootExact})
    add("block_root", with_knobs<block_root>, Counts[root],
        with([&](block_knobs& k) { k.root = root; }));
  for (const int steps : {0, 2, 3})
    add("block_normalise", with_knobs<block_normalise>, Counts[steps],
        with([&](block_knobs& k) { k.newton_steps = steps; }));
  for (const int squarings : {0, 4, 6})
    add("block_shade", with_knobs<block_shade>, Counts[squarings],
        with([&](block_knobs& k) { k.specular_squarings = squarings; }));
  for (const int lanes : {1, 4, 8})
    add("block_spheres", with_knobs<block_spheres>, Counts[lanes],
        with([&](block_knobs& k) { k.lanes = lanes; }));
  for (const int cores : {1, 4, 64}) {
    const block_knobs k = with([&](block_knobs& knobs) { knobs.cores = cores; });
    add("block_scheduler", with_knobs<block_scheduler>, Counts[std::min(cores, 9)], k);
    add("block_bus", with_knobs<block_bus>, Counts[std::min(cores, 9)], k);
  }
  add("block_convert", with_knobs<block_convert>, "default", {});
  add("block_convert", with_knobs<block_convert>, "others",
      with([](block_knobs& k) { k.fraction_bits = 13; }));
  for (const int lanes : {1, 2, 4, 8})
    add("block_core", with_knobs<block_core>, Counts[lanes],
        with([&](block_knobs& k) { k.lanes = lanes; }));
  add("block_core", with_knobs<block_core>, "others", with([](block_knobs& k) {
        k.max_passes = 1;
        k.newton_steps = 0;
        k.specular_squarings = 0;
        k.cull = BlockCullOff;
        k.background = 0x123456;
        k.size = BlockSize1920;
      }));
  add("block_core", with_knobs<block_core>, "cone_heron", with([](block_knobs& k) {
        k.cull = BlockCullCone;
        k.root = BlockRootHeron;
      }));
  add("block_core", with_knobs<block_core>, "cone_exact", with([](block_knobs& k) {
        k.cull = BlockCullCone;
        k.root = BlockRootExact;
        k.lanes = 1;
      }));
  for (const int lanes : {2, 4})
    add("block_core", with_knobs<block_core>, lanes == 2 ? "shadows_heron" : "shadows",
        with([&](block_knobs& k) {
          k.shadow_rays = 1;
          k.max_passes = 8;
          k.lanes = lanes;
          k.cull = BlockCullOff;
          k.root = lanes == 2 ? BlockRootHeron : BlockRootTrick;
        }));
  return all;
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
