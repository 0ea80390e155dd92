// Promises of sc/sphere/sphere_core.h: the vectors of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_core.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/sphere/four_scene.h"
#include "tests/sphere/picture_checksum.h"
#include "tests/support/four_pixels.h"

namespace racebeam {
namespace {

constexpr int Size512 = 1 << 5, Reflections3 = 3 << 2, Key2 = 15 & ~4;

struct Sums {
  std::uint64_t clocks, rays, shadow_rays, roots, sphere_tests, passes, overflows;
  std::uint32_t checksum;
};

void expect_picture(const sphere_board& board, const Sums& sums) {
  const sphere_tables tables = four_tables();
  sphere_core core({}, tables, board);
  core.load(four_spheres());
  core.draw(board);
  const sphere_counters& n = core.counters();
  EXPECT_EQ(n.clocks, sums.clocks);
  EXPECT_EQ(n.primary_rays + n.reflected_rays, sums.rays);
  EXPECT_EQ(n.shadow_rays, sums.shadow_rays);
  EXPECT_EQ(n.roots, sums.roots);
  EXPECT_EQ(n.sphere_tests, sums.sphere_tests);
  EXPECT_EQ(n.passes, sums.passes);
  EXPECT_EQ(n.overflows, sums.overflows);
  EXPECT_EQ(picture_checksum(core.picture(), core.columns(), core.rows()), sums.checksum);
  EXPECT_EQ(n.words, 245760u);
  EXPECT_EQ(n.buffer_stalls, 0u);
  EXPECT_EQ(n.buffer_lost, 0u);
  EXPECT_EQ(std::accumulate(n.state_clocks.begin(), n.state_clocks.end(), std::uint64_t{0}),
            n.clocks + n.host_clocks);
  EXPECT_EQ(std::accumulate(n.buffer_fill.begin(), n.buffer_fill.end(), std::uint64_t{0}),
            n.clocks);
}

TEST(SphereCore, PlainPictureOfFour) {
  expect_picture({Size512, 15}, {9000673, 245760, 10666, 268240, 1259426, 11814, 0, 0xb8c354c2});
}
TEST(SphereCore, PictureOfFourWithReflections) {
  expect_picture({Size512 | Reflections3, 15},
                 {9425850, 257568, 11839, 282412, 1320866, 13003, 0, 0x38209886});
}
TEST(SphereCore, PictureOfFourWithReflectionsAndPlanes) {
  expect_picture({Size512 | Reflections3, Key2},
                 {79822445, 973420, 966405, 1976130, 8528588, 968255, 24469, 0xb9cbe708});
}

TEST(SphereCore, ExplainedStatesAddUpToThePixelsClocks) {
  const sphere_tables tables = four_tables();
  const sphere_board boards[4] = {{Size512, 15},
                                  {Size512 | Reflections3, 15},
                                  {Size512 | Reflections3, Key2},
                                  {Size512 | Reflections3 | 2, Key2}};
  for (int mode = 0; mode < 4; ++mode) {
    sphere_core core({}, tables, boards[mode]);
    core.load(four_spheres());
    for (const four_pixel& p : FourPixels) {
      int clocks = 0;
      for (const sphere_step& step : core.explain(p.x, p.y)) clocks += step.clocks;
      EXPECT_EQ(clocks, p.by_mode[mode].clocks) << p.x << "," << p.y << " mode " << mode;
    }
  }
}

TEST(SphereCore, WidePictureHas640Columns) {
  sphere_knobs k;
  k.wide = 1;
  const sphere_tables tables;
  sphere_core core(k, tables, {});
  core.load(four_spheres());
  core.draw({});
  EXPECT_EQ(core.columns(), 640);
  EXPECT_EQ(core.counters().words, 640u * 480);
  EXPECT_EQ(core.picture().size(), std::size_t{1} << 19);
  // The same rays as the middle of the picture of 512 columns.
  sphere_core plain({}, tables, {});
  plain.load(four_spheres());
  plain.draw({});
  const auto wide_words = core.picture(), words = plain.picture();
  for (int x = 0; x < 512; ++x)
    ASSERT_EQ(wide_words[static_cast<std::size_t>(core.address(x + 64, 240))],
              words[static_cast<std::size_t>(plain.address(x, 240))])
        << x;
}

TEST(SphereCore, DroppedWordsAreCounted) {
  sphere_knobs k;
  k.when_full = WhenFullDrop;
  k.write_buffer_depth = 8;
  const sphere_tables tables;
  sphere_core core(k, tables, {});
  core.load(four_spheres());
  core.draw({});
  const sphere_counters& n = core.counters();
  EXPECT_GT(n.buffer_lost, 0u);
  EXPECT_EQ(n.buffer_stalls, 0u);
  EXPECT_EQ(n.words, n.store_writes + n.buffer_lost +
                         static_cast<std::uint64_t>(core.store().buffer().fill(k.store())));
}

TEST(SphereCore, SwitchesMoveTheLightBetweenPictures) {
  const sphere_tables tables;
  const sphere_board board{1 << 17, 15};
  sphere_core core({}, tables, board);
  for (int picture = 0; picture < 2; ++picture) {
    core.load({});
    core.draw(board);
  }
  core.load({});
  EXPECT_EQ(core.table().row(0).centre, (vec3{17 * 4096, 15 * 4096, -4096}));
}

}  // namespace
}  // namespace racebeam
