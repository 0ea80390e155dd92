// The RTL of the voxel tracer's units beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sc/voxel/voxel_leaf.h"
#include "sc/voxel/voxel_parameters.h"
#include "sc/voxel/voxel_walker.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {
namespace {

using Module = std::unique_ptr<sc_core::sc_module>;

struct Pair {
  std::string unit, name;
  Module (*make)(const voxel_knobs& k);
  voxel_knobs k;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.unit << ", " << pair.name; }

template <class Unit>
Module with_knobs(const voxel_knobs& k) {
  return std::make_unique<Unit>("model", k);
}

voxel_knobs world(const vec3& size, const vec3& voxel, int levels, int memory_clocks) {
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.levels = levels;
  k.memory_clocks = memory_clocks;
  return k;
}

struct Rules {
  int leaf, leaf_steps, raise, group_fetch;
};
voxel_knobs with(voxel_knobs k, const Rules& rules) {
  k.leaf = rules.leaf;
  k.leaf_steps = rules.leaf_steps;
  k.raise = rules.raise;
  k.group_fetch = rules.group_fetch;
  return k;
}

std::vector<Pair> pairs() {
  const voxel_knobs tiny;
  const voxel_knobs cubes = world({64, 64, 32}, {1, 1, 1}, 9, 2);
  const voxel_knobs odd = world({96, 160, 64}, {2, 4, 1}, 4, 3);
  const voxel_knobs large = world({2048, 16384, 256}, {16, 8, 1}, 9, 8);
  return {{"voxel_leaf", "tiny", with_knobs<voxel_leaf>, tiny},
          {"voxel_leaf", "odd", with_knobs<voxel_leaf>, odd},
          {"voxel_leaf", "large", with_knobs<voxel_leaf>, large},
          {"voxel_walker", "tiny", with_knobs<voxel_walker>, tiny},
          {"voxel_walker", "tiny_in_groups", with_knobs<voxel_walker>,
           with(tiny, {VoxelLeafMarch, 2, VoxelRaiseOne, 1})},
          {"voxel_walker", "cubes", with_knobs<voxel_walker>,
           with(cubes, {VoxelLeafVoxel, 1, VoxelRaiseOne, 0})},
          {"voxel_walker", "cubes_in_groups_all_up", with_knobs<voxel_walker>,
           with(cubes, {VoxelLeafVoxel, 1, VoxelRaiseAll, 1})},
          {"voxel_walker", "odd_in_groups", with_knobs<voxel_walker>,
           with(odd, {VoxelLeafMarch, 3, VoxelRaiseOne, 1})},
          {"voxel_walker", "large_all_up", with_knobs<voxel_walker>,
           with(large, {VoxelLeafMarch, 8, VoxelRaiseAll, 0})},
          {"voxel_walker", "one_level", with_knobs<voxel_walker>,
           with(world({48, 80, 16}, {1, 2, 1}, 1, 1), {VoxelLeafMarch, 7, VoxelRaiseOne, 0})}};
}

class VoxelLockstep : public testing::TestWithParam<Pair> {
 protected:
  void agrees_in_random_traffic(int clocks) {
    constexpr unsigned Seed = 1;
    const Pair& pair = GetParam();
    const Module unit = pair.make(pair.k);
    Lockstep lockstep("lockstep", pair.unit, *unit, voxel_parameters(pair.k),
                      PluginMaker(voxel_parameters(pair.k)).own(pair.unit));
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
INSTANTIATE_TEST_SUITE_P(Pairs, VoxelLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(VoxelLockstep, AgreesInRandomTraffic) { agrees_in_random_traffic(40'000); }

using LongVoxelLockstep = VoxelLockstep;
INSTANTIATE_TEST_SUITE_P(LongPairs, LongVoxelLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(LongVoxelLockstep, AgreesInLongRandomTraffic) { agrees_in_random_traffic(1'000'000); }

}  // namespace
}  // namespace racebeam
