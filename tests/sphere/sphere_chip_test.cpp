// The wired sphere tracer and sphere_core draw the same pictures in the same clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/sphere/chip_and_core.h"

namespace racebeam {
namespace {

TEST(SphereChip, TwoPlainPicturesAreTheCores) {
  ChipAndCore both({}, {0, 15});
  for (int picture = 0; picture < 2; ++picture) {
    ASSERT_NO_FATAL_FAILURE(both.draw());
    both.expect_same();
  }
}

TEST(SphereChip, StallsOfASmallBufferAreTheCores) {
  sphere_knobs k;
  k.write_buffer_depth = 8;
  k.write_policy = WritePolicyBlanking;
  k.write_each_pass = 1;
  ChipAndCore both(k, {2 << 2, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_stalls, 0u);
  both.expect_same();
}

TEST(SphereChip, LostWordsAreTheCores) {
  sphere_knobs k;
  k.write_buffer_depth = 4;
  k.when_full = WhenFullDrop;
  k.clocks_per_pixel = 2;
  ChipAndCore both(k, {0, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_lost, 0u);
  both.expect_same();
}

TEST(SphereChip, OtherNumbersAreTheCores) {
  sphere_knobs k;
  k.fraction_bits = 8;
  k.colour_bits = 8;
  k.root_bits_per_clock = 3;
  k.divide_clocks = 9;
  k.shadow_rays = 0;
  ChipAndCore both(k, {3 << 2, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

TEST(LongSphereChip, PlanesAndTheirShadowsAreTheCores) {
  sphere_knobs k;
  k.plane_shadows = 1;
  k.write_policy = WritePolicyFree;
  ChipAndCore both(k, {3 << 2, 15 & ~4});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

}  // namespace
}  // namespace racebeam
