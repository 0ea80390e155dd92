// The RTL of the sphere tracer's units beside their models, on random traffic, for their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "sc/sphere/divider_unit.h"
#include "sc/sphere/plane_table.h"
#include "sc/sphere/root_unit.h"
#include "sc/sphere/sphere_host_link.h"
#include "sc/sphere/sphere_inputs.h"
#include "sc/sphere/sphere_parameters.h"
#include "sc/sphere/sphere_raygen.h"
#include "sc/sphere/sphere_shader.h"
#include "sc/sphere/sphere_table.h"
#include "sc/sphere/sphere_tracer.h"
#include "sc/sphere/vector_unit.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/sphere_twins.h"
#include "tests/sphere/four_scene.h"

namespace racebeam {
namespace {

using Module = std::unique_ptr<sc_core::sc_module>;

struct Pair {
  std::string unit, name;
  Module (*make)(const sphere_knobs& k, const sphere_tables& tables);
  sphere_knobs k;
  sphere_tables tables;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.unit << ", " << pair.name; }

template <class Unit>
Module with_knobs(const sphere_knobs& k, const sphere_tables&) {
  return std::make_unique<Unit>("model", k);
}
template <class Unit>
Module with_tables(const sphere_knobs&, const sphere_tables& tables) {
  return std::make_unique<Unit>("model", tables);
}
Module make_vector_unit(const sphere_knobs&, const sphere_tables&) {
  return std::make_unique<vector_unit>("model");
}

template <class Set>
sphere_knobs knobs_with(const Set& set) {
  sphere_knobs k;
  set(k);
  return k;
}

/// Every knob otherwise than it is by default.
sphere_knobs others() {
  return knobs_with([](sphere_knobs& k) {
    k.fraction_bits = 8;
    k.colour_bits = 8;
    k.root_bits_per_clock = 3;
    k.divide_clocks = 9;
    k.table_entries = 5;
    k.write_each_pass = 1;
    k.plane_shadows = 1;
    k.min_weight = 1000;
    k.wide = 1;
  });
}

/// Where the scene starts, and planes, with values that nothing else has.
sphere_tables other_tables() {
  sphere_tables tables = four_tables();
  tables.start = {{-0x123456, 0x2345, -0x7ffffe}, {0x7fffff, -1, 0x654321}, -0x5432};
  tables.planes[2] = {{-4096, 1, 0x7abcde}, -3, {31, 1, 16}, 0xfff, 15, true, {1, 30, 4000}};
  tables.planes.push_back({{0, 2, -3}, 99, {1, 2, 3}, 1, 8, true, {5, 6, 7}});
  return tables;
}

std::vector<Pair> pairs() {
  const sphere_tables none;
  std::vector<Pair> all = {
      {"sphere_inputs", "default", with_tables<sphere_inputs>, {}, none},
      {"sphere_inputs", "others", with_tables<sphere_inputs>, {}, other_tables()},
      {"plane_table", "default", with_tables<plane_table>, {}, none},
      {"plane_table", "others", with_tables<plane_table>, {}, other_tables()},
      {"vector_unit", "default", make_vector_unit, {}, none}};
  const std::pair<const char*, Module (*)(const sphere_knobs&, const sphere_tables&)> units[] = {
      {"sphere_host_link", with_knobs<sphere_host_link>},
      {"sphere_table", with_knobs<sphere_table>},
      {"sphere_raygen", with_knobs<sphere_raygen>},
      {"root_unit", with_knobs<root_unit>},
      {"divider_unit", with_knobs<divider_unit>},
      {"sphere_tracer", with_knobs<sphere_tracer>},
      {"sphere_shader", with_knobs<sphere_shader>}};
  for (const auto& [unit, make] : units) {
    all.push_back({unit, "default", make, {}, none});
    all.push_back({unit, "others", make, others(), none});
  }
  all.push_back({"sphere_tracer", "unshadowed", with_knobs<sphere_tracer>,
                 knobs_with([](sphere_knobs& k) { k.shadow_rays = 0; }), none});
  all.push_back({"root_unit", "at_once", with_knobs<root_unit>,
                 knobs_with([](sphere_knobs& k) { k.root_bits_per_clock = 22; }), none});
  all.push_back({"divider_unit", "at_once", with_knobs<divider_unit>,
                 knobs_with([](sphere_knobs& k) { k.divide_clocks = 1; }), none});
  return all;
}

constexpr unsigned Seed = 1;

/// The RTL beside the model.
struct Beside {
  explicit Beside(const Pair& pair)
      : unit(pair.make(pair.k, pair.tables)),
        lockstep("lockstep", pair.unit, *unit, sphere_parameters(pair.k, pair.tables),
                 sphere_plugins(pair.k, pair.tables).own(pair.unit)),
        bench(*unit, &lockstep.clk_i) {}

  void expect_agreement(int clocks) {
    bench.clock(clocks);
    EXPECT_GE(lockstep.clocks(), static_cast<std::uint64_t>(clocks));
    EXPECT_EQ(lockstep.differences(), 0u)
        << "seed " << Seed << "\n"
        << (lockstep.first() ? difference_table(*lockstep.first()) : "");
  }

  const Module unit;
  Lockstep lockstep;
  UnitBench bench;
};

class SphereLockstep : public testing::TestWithParam<Pair> {
 protected:
  void agrees_in_random_traffic(int clocks) {
    Beside beside(GetParam());
    RandomTraffic traffic(beside.bench, LegalInputs({}), Seed);
    beside.bench.between_edges([&] { traffic.next(); });
    beside.expect_agreement(clocks);
  }
};
std::string name_of(const testing::TestParamInfo<Pair>& info) {
  return info.param.unit + "_" + info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Pairs, SphereLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(SphereLockstep, AgreesInRandomTraffic) { agrees_in_random_traffic(20'000); }

using LongSphereLockstep = SphereLockstep;
INSTANTIATE_TEST_SUITE_P(LongPairs, LongSphereLockstep, testing::ValuesIn(pairs()), name_of);
TEST_P(LongSphereLockstep, AgreesInLongRandomTraffic) { agrees_in_random_traffic(1'000'000); }

/// Black pixels, six clocks each: to the end of a picture, which random traffic never sees.
void expect_agreement_to_the_end(const sphere_knobs& k, bool narrow) {
  Beside beside({"sphere_tracer", "", with_knobs<sphere_tracer>, k, {}});
  auto& bench = beside.bench;
  bench.clock();
  for (const char* on : {"rst_ni", "loaded_i", "root_done_i", "divider_done_i", "word_ready_i"})
    bench[on].drive(1);
  bench["radius2_i"].drive(1);  // the eye is in a sphere
  bench["narrow_i"].drive(narrow);
  beside.expect_agreement(6 * k.columns(narrow) * k.rows(narrow) + 10);
  EXPECT_EQ(bench["x_o"].value(), 1u) << "of the next picture";
  EXPECT_EQ(bench["y_o"].value(), 0u);
}
TEST(TracerLockstep, AgreesToTheEndOfANarrowPicture) { expect_agreement_to_the_end({}, true); }
TEST(LongTracerLockstep, AgreesToTheEndOfAPicture) { expect_agreement_to_the_end({}, false); }
TEST(LongTracerLockstep, AgreesToTheEndOfAWidePicture) {
  expect_agreement_to_the_end(others(), false);
}

/// Clocks in HOST, until the scene that is built in comes; random traffic is never so quiet.
TEST(HostLinkLockstep, AgreesWhenNoCpuAnswers) {
  Beside beside({"sphere_host_link", "", with_knobs<sphere_host_link>, {}, {}});
  auto& bench = beside.bench;
  bench.clock();
  bench["rst_ni"].drive(1);
  bench["host_i"].drive(1);
  bench.drive("light", "_i", {1, -2, 3});
  bench.clock(HostPatience);
  EXPECT_EQ(bench["table_write_o"].value(), 0u);
  RandomTraffic traffic(bench,
                        LegalInputs({{"rst_ni", [](std::uint64_t) { return 1u; }},
                                     {"valid_i", [](std::uint64_t) { return 0u; }}}),
                        Seed);
  bench.between_edges([&] { traffic.next(); });
  beside.expect_agreement(2000);
}

}  // namespace
}  // namespace racebeam
