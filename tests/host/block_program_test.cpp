// The block renderer's host: how it moves spheres, and the load bar that it draws.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/block_program.h"

#include <gtest/gtest.h>

#include "tb/host/load_bar.h"
#include "tb/host/sphere_motion.h"

namespace racebeam {
namespace {

/// The three spheres of the sphere tracer's motion vectors, at an eighth of the size, y turned up.
BlockProgram three() {
  const double s = 0.125;
  BlockProgram program;
  program.box = {{-15 * s, -15 * s, 5 * s}, {15 * s, 15 * s, 35 * s}};
  program.set_bodies({{{-9 * s, 0, 15 * s}, {0.5 * s, -0.125 * s, 0}, 5 * s},
                      {{9 * s, -0.5 * s, 15 * s}, {-0.25 * s, 0, 0.0625 * s}, 5 * s},
                      {{0, 9 * s, 20 * s}, {0, -0.375 * s, -0.125 * s}, 4 * s}});
  return program;
}

void expect_centre(const block_ball& ball, const Vector3& wanted) {
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(ball.centre[n], wanted[n], 1e-5) << "axis " << n;
}

TEST(BlockMotion, SpheresMoveAndCollideAsThoseOfTheSphereTracer) {
  const block_tables tables = tables_of(three(), {}, 14);
  expect_centre(tables.balls[0], {-3.2309 / 8, -3.5964 / 8, 13.9400 / 8});
  expect_centre(tables.balls[1], {5.5 / 8, -0.5 / 8, 15.875 / 8});
  expect_centre(tables.balls[2], {1.2309 / 8, 5.5964 / 8, 19.3100 / 8});
}

TEST(BlockMotion, TimeSkipIsStepsAPicture) {
  const BlockProgram program = three();
  block_knobs k;
  k.time_skip = 7;
  EXPECT_EQ(tables_of(program, k, 2).balls[2].centre, tables_of(program, {}, 14).balls[2].centre);
  k.time_skip = 0;
  EXPECT_EQ(tables_of(program, k, 9).balls[2].centre, program.balls[2].centre);
}

TEST(LoadBar, ASquareIsAsBrightAsItsCoreWasBusyInThePicturesOfLate) {
  block_knobs k;
  k.cores = 2;
  k.load_bar = 1;
  LoadBar bar(k);
  EXPECT_EQ(bar.brightness(0), 0);
  block_counters counters;
  counters.clocks = 100;
  counters.busy_by_core = {100, 20};
  bar.add(counters);
  EXPECT_EQ(bar.brightness(0), 255);
  EXPECT_EQ(bar.brightness(1), 51);
  counters.busy_by_core = {0, 20};
  bar.add(counters);
  EXPECT_EQ(bar.brightness(0), 128);
  for (int n = 0; n < LoadBar::Pictures - 1; ++n) bar.add(counters);
  EXPECT_EQ(bar.brightness(0), 0) << "the first is forgotten";
  EXPECT_EQ(bar.brightness(1), 51);
}

TEST(LoadBar, LiesOverThePixelsThatItCovers) {
  block_knobs k;
  k.cores = 3;
  k.load_bar = 1;
  LoadBar bar(k);
  block_counters counters;
  counters.clocks = 1;
  counters.busy_by_core = {1, 1, 1};
  bar.add(counters);
  PackedPicture picture{k.columns(), k.rows(), 8, {}};
  for (std::size_t n = 0; n < picture.pixels(); ++n) picture.push(0);
  bar.draw(picture);
  int covered = 0;
  for (int y = 0; y < k.rows(); ++y)
    for (int x = 0; x < k.columns(); ++x) {
      const bool under = LoadBar::covers(k, x, y);
      covered += under;
      ASSERT_EQ(picture.colour(static_cast<std::size_t>(y * k.columns() + x)),
                under ? 0xffffffu : 0u)
          << x << "," << y;
    }
  EXPECT_EQ(covered, 3 * 16);
  k.load_bar = 0;
  EXPECT_FALSE(LoadBar::covers(k, 0, k.rows() - 1));
}

}  // namespace
}  // namespace racebeam
