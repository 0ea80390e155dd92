// The RTL of the voxel tracer's units beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sc/voxel/voxel_address.h"
#include "sc/voxel/voxel_camera.h"
#include "sc/voxel/voxel_leaf.h"
#include "sc/voxel/voxel_limits.h"
#include "sc/voxel/voxel_parameters.h"
#include "sc/voxel/voxel_setup.h"
#include "sc/voxel/voxel_walker.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/random_traffic.h"
#include "tests/support/scratch_folder.h"
#include "tests/voxel/knob_sets.h"

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
template <class Unit>
Module without_knobs(const voxel_knobs&) {
  return std::make_unique<Unit>("model");
}

std::vector<Pair> pairs() {
  const auto leaf = [](const char* name, const voxel_knobs& k) {
    return Pair{"voxel_leaf", name, with_knobs<voxel_leaf>, k};
  };
  const auto walker = [](const char* name, const voxel_knobs& k) {
    return Pair{"voxel_walker", name, with_knobs<voxel_walker>, k};
  };
  return {{"voxel_address", "tiny", with_knobs<voxel_address>, tiny_set()},
          {"voxel_address", "odd", with_knobs<voxel_address>, odd_set()},
          {"voxel_setup", "odd", without_knobs<voxel_setup>, odd_set()},
          {"voxel_camera", "odd", without_knobs<voxel_camera>, odd_set()},
          {"voxel_limits", "odd", without_knobs<voxel_limits>, odd_set()},
          leaf("tiny", tiny_set()),
          leaf("odd", odd_set()),
          leaf("large", large_set()),
          walker("tiny", tiny_set()),
          walker("tiny_in_groups", with(tiny_set(), {2, false, true, false})),
          walker("cubes", cubes_set()),
          walker("cubes_one_up", with(cubes_set(), {1, true, false, false})),
          walker("odd", odd_set()),
          walker("coarse", coarse_set()),
          walker("one_level", one_level_set()),
          walker("large", large_set())};
}

class VoxelLockstep : public testing::TestWithParam<Pair> {
 protected:
  /// Of the unit's own RTL.
  void agrees_in_random_traffic(int clocks) {
    const std::vector<rtl_parameter> wanted = voxel_parameters(GetParam().k);
    agrees(wanted, PluginMaker(wanted).own(GetParam().unit), clocks);
  }
  void agrees(const std::vector<rtl_parameter>& wanted, const std::string& plugin, int clocks) {
    constexpr unsigned Seed = 1;
    const Pair& pair = GetParam();
    const Module unit = pair.make(pair.k);
    Lockstep lockstep("lockstep", pair.unit, *unit, wanted, plugin);
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

// What yosys makes of it, with the parameters that it has.
class VoxelNetlist : public VoxelLockstep {
 protected:
  std::string settings() const {
    std::ifstream file(RACEBEAM_SOURCE_DIR "/rtl/voxel/" + GetParam().unit + ".sv");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string all;
    for (const rtl_parameter& each : voxel_parameters(GetParam().k))
      if (text.find("parameter int " + each.name + " =") != std::string::npos)
        all += " " + each.name + "=" + std::to_string(each.value);
    return all;
  }
};
std::vector<Pair> netlists() {
  std::vector<Pair> some;
  for (const Pair& pair : pairs())
    if (pair.name == "odd" || pair.name == "cubes") some.push_back(pair);
  return some;
}
INSTANTIATE_TEST_SUITE_P(Netlists, VoxelNetlist, testing::ValuesIn(netlists()), name_of);
TEST_P(VoxelNetlist, AgreesInRandomTraffic) {
  const ScratchFolder folder;
  const std::string netlist = folder / (GetParam().unit + ".v");
  const std::string command = "'" RACEBEAM_SOURCE_DIR "/scripts/netlist' " + GetParam().unit +
                              " '" + netlist + "'" + settings();
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  agrees({}, PluginMaker({}).users(GetParam().unit, netlist), 20'000);
}

}  // namespace
}  // namespace racebeam
