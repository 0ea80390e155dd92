// How many syntheses the points of a sweep take.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <set>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/sweep/silicon_plan.h"
#include "tb/sweep/sweep_points.h"

namespace racebeam {
namespace {

constexpr int UnitsOfTheChip = 11;  // without the sound

SweepFile sweep_of(const std::vector<std::pair<std::string, std::vector<int>>>& values) {
  SweepFile file;
  for (const auto& [name, list] : values)
    file.knobs.push_back({swept_knob(beam_engine(), name), list});
  return file;
}

class SiliconSharing : public testing::Test {
 protected:
  /// The number of points.
  int want(const SweepFile& file) {
    const std::vector<SweepPoint> points = sweep_points(file).points;
    for (const SweepPoint& point : points) plan.want(point.k);
    EXPECT_EQ(plan.without_sharing(), UnitsOfTheChip * std::int64_t(points.size()));
    std::set<std::string> hashes;
    for (const UnitParameters& unit : plan.missing())
      EXPECT_TRUE(hashes.insert(unit.hash).second) << unit.text();
    return static_cast<int>(points.size());
  }
  double share() const { return double(plan.missing().size()) / double(plan.without_sharing()); }

  const Silicon silicon{beam_engine()};
  SiliconPlan plan{silicon, [](const std::string&) { return std::nullopt; }};
};

TEST_F(SiliconSharing, EightKnobsTakeAQuarterOfTheSyntheses) {
  SweepFile file = sweep_of({{"interval_stack_depth", {1, 2, 3, 4, 6, 8}},
                             {"fifo_entries", {4, 6, 8, 10, 12, 16}},
                             {"fifo_short_length_bits", {4, 5, 6, 8}},
                             {"hurry_threshold", {0, 8, 16, 32, 64}},
                             {"corner_factor_bits", {6, 7, 8, 9, 10, 12}},
                             {"partial_products_cut", {0, 3, 5, 6, 7}},
                             {"skip_shared_edges", {0, 1}},
                             {"bisection", {0, 1}}});
  file.search.method = SearchMethod::Sobol;
  file.search.points = 64;
  EXPECT_EQ(want(file), 65);
  EXPECT_LE(share(), 0.25);
}

TEST_F(SiliconSharing, AGridTakesThreeOfAHundred) {
  want(sweep_of({{"interval_stack_depth", {1, 2, 3, 4, 6, 8}},
                 {"fifo_entries", {4, 6, 8, 10, 12}},
                 {"hurry_threshold", {0, 8, 16, 32, 64, 128}}}));
  // scene, sequencer ...: once; subdivider 6 * 6, stacks 6, interval_fifo 5
  EXPECT_EQ(plan.missing().size(), 8u + 36 + 6 + 5);
  EXPECT_LE(share(), 0.03);
}

TEST_F(SiliconSharing, WhatIsStoredIsNotMissing) {
  plan.want(knobs());
  const auto all = plan.missing();
  SiliconPlan other(silicon, [&](const std::string& hash) -> std::optional<UnitSilicon> {
    for (const UnitParameters& unit : all)
      if (unit.hash == hash) return UnitSilicon{hash, unit.unit, "", GenericRecipe, 2, 5, {}};
    return std::nullopt;
  });
  other.want(knobs());
  knobs k;
  k.fifo_entries = 11;
  EXPECT_TRUE(other.missing().empty());
  EXPECT_EQ(other.of(knobs()).flip_flops, 2 * UnitsOfTheChip);
  EXPECT_EQ(other.of(knobs()).cells, 5 * UnitsOfTheChip);
  EXPECT_EQ(other.of(k).fault, "interval_fifo with FifoEntries=11 is not synthesised yet");
  other.want(k);
  ASSERT_EQ(other.missing().size(), 1u);
  other.put(other.missing()[0], {{}, "interval_fifo: too large"});
  EXPECT_TRUE(other.missing().empty()) << "it has failed";
  EXPECT_EQ(other.of(k).fault, "interval_fifo: too large");
  EXPECT_EQ(other.of(knobs()).fault, "");
}

TEST_F(SiliconSharing, APointOfTheModelOnlySaysSo) {
  engine other = beam_engine();
  other.parameters = [](const knob_values& k) {
    return std::vector<rtl_parameter>{{"Glow", knobs(k).fifo_merge, "the knob glow"}};
  };
  const Silicon with_glow(other);
  SiliconPlan points(with_glow, [](const std::string&) { return std::nullopt; });
  knobs k;
  k.fifo_merge = 0;
  points.want(k);
  EXPECT_TRUE(points.missing().empty());
  EXPECT_EQ(points.of(k).fault, "the knob glow is of the model only: no unit's RTL has Glow=0");
}

}  // namespace
}  // namespace racebeam
