// In how many pixels the chip differs from the golden tracers, by cause.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/golden_compare.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "tests/support/core_picture.h"

namespace racebeam {
namespace {

int pixels(const GoldenCounts& counts, const std::string& cause) {
  const auto& causes = golden_causes();
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (causes[i].name == cause) return counts.by_cause.at(i);
  ADD_FAILURE() << "no cause " << cause;
  return -1;
}

GoldenReport compare(int frame, const knobs& k = {}) {
  return golden_compare({}, frame, k, core_picture(frame, k));
}

TEST(GoldenCompare, LimitsAddUpToTheDifferenceFromTrace4) {
  for (const int frame : {1023, 7167, 9535, 12543}) {
    const GoldenCounts counts = compare(frame).counts;
    const auto first = counts.by_cause.begin();
    EXPECT_EQ(std::accumulate(first, first + golden_limits(), 0), counts.by_tracer[1]) << frame;
    EXPECT_EQ(pixels(counts, "unexplained"), 0) << frame;
    EXPECT_GT(pixels(counts, "multiplier_cut"), 0) << frame;
    EXPECT_GT(pixels(counts, "camera_rounding"), 0) << frame;
  }
}

TEST(GoldenCompare, AStarvedFrameIsPutDownToTheBeam) {
  const GoldenCounts counts = compare(7167).counts;
  EXPECT_GT(pixels(counts, "starved") + pixels(counts, "give_up"), counts.by_tracer[1] / 2);
  const GoldenCounts calm = compare(1023).counts;
  EXPECT_EQ(pixels(calm, "starved") + pixels(calm, "give_up"), 0);
}

TEST(GoldenCompare, ACauseThatIsOffCountsNothing) {
  knobs k;
  k.partial_products_cut = 0;
  k.corner_factor_bits = 12;
  k.interlace = 0;
  const GoldenCounts counts = compare(1023, k).counts;
  for (const char* cause : {"multiplier_cut", "corner_shift", "interlace_residue", "other_knobs"})
    EXPECT_EQ(pixels(counts, cause), 0) << cause;
  k.dr_bits = 9;
  EXPECT_GT(pixels(compare(1023, k).counts, "other_knobs"), 0);
}

TEST(GoldenCompare, TheRoundingOfRaysAddsUpToTrace4AgainstGeometry) {
  constexpr int Frame = 7167;
  const GoldenWorld world(Frame, {});
  const GoldenCamera camera(Frame);
  const GoldenCounts counts = compare(Frame).counts;
  int sum = 0;
  for (const char* cause : {"ray_steps", "ray_bits", "ray_rest"}) {
    EXPECT_GT(pixels(counts, cause), 0) << cause;
    sum += pixels(counts, cause);
  }
  EXPECT_EQ(sum, golden_difference(golden_picture(GoldenTracer::Trace4, world, camera),
                                   golden_picture(GoldenTracer::Geometry, world, camera)));
}

TEST(GoldenCompare, KnobsThatTheTracersDoNotFollowAreExplained) {
  knobs k;
  k.ddr_fraction_bits = 5;
  k.head_start = 320;
  k.stepping = SteppingFractionDr2;
  k.stepping_fraction_bits = 3;
  k.corner_rounding = 1;
  k.fifo_merge = 0;
  const GoldenCounts counts = compare(1023, k).counts;
  EXPECT_EQ(pixels(counts, "unexplained"), 0);
  EXPECT_GT(pixels(counts, "other_knobs"), 0);
}

TEST(GoldenCompare, APixelThatNoLimitExplainsIsUnexplained) {
  for (const int frame : {5119, 1023}) {  // without and with interlace
    GoldenPicture broken = core_picture(frame, {});
    for (int i = 1000; i < 1100; ++i) broken[i] ^= 1;
    EXPECT_EQ(pixels(golden_compare({}, frame, {}, broken).counts, "unexplained"), 100) << frame;
  }
}

TEST(GoldenCompare, TheDifferenceImageShowsWhichTracerDisagrees) {
  const GoldenPicture chip = {0b111111, 0b101010, 0b010101, 0b110000};
  const GoldenPicture other = {0b111111, 0b101010, 0b010101, 0};
  GoldenPicture geometry = other, trace_2 = other;
  geometry[2] = 0;
  trace_2[1] = 0;
  EXPECT_EQ(golden_difference_picture(chip, {trace_2, other, geometry}),
            (GoldenPicture{0b010101, 0b001111, 0b110011, 0b111100}));
}

TEST(GoldenCompare, CountsAddUp) {
  GoldenCounts sum, one;
  one.by_tracer = {1, 2, 3};
  one.by_cause.front() = 4;
  sum += one;
  sum += one;
  EXPECT_EQ(sum.by_tracer, (std::array<int, 3>{2, 4, 6}));
  EXPECT_EQ(sum.by_cause.front(), 8);
  EXPECT_EQ(sum.by_cause.size(), golden_causes().size());
}

}  // namespace
}  // namespace racebeam
