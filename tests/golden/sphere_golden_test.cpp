// The sphere tracer's pictures against the golden ones: within the bounds of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/sphere_golden.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "sc/sphere/sphere_core.h"

namespace racebeam {
namespace {

constexpr int One = 4096;

SphereGoldenScene four(int reflections, bool planes, int checker) {
  SphereGoldenScene scene;
  scene.spheres = builtin_spheres(false);
  const auto plane = [](const vec3& normal, int distance, int grey, int checker) {
    return plane_row{normal, distance * One, {grey, grey, grey}, 0x800, checker, false, {}};
  };
  scene.tables.planes = {plane({0, 0, -One}, 40, 0, 0), plane({0, -One, 0}, 22, 29, checker),
                         plane({-One, 0, 0}, 26, 0, 0), plane({One, 0, 0}, 26, 0, 0)};
  scene.reflections = reflections;
  scene.planes = planes;
  return scene;
}

struct Difference {
  double differing, by_more, rmse;  // shares of pixels; levels
};

/// Of every second pixel of every second line.
Difference difference(const SphereGoldenScene& scene) {
  const sphere_board board{1 << 5 | scene.reflections << 2 | (scene.sub_rays == 9 ? 2 : 0),
                           scene.planes ? 15 & ~4 : 15};
  sphere_core core({}, scene.tables, board);
  core.load(scene.spheres);
  core.draw(board);
  const auto words = core.picture();
  const SphereGolden golden(scene);
  int pixels = 0, differing = 0, by_more = 0;
  double squares = 0;
  for (int y = 0; y < core.rows(); y += 2)
    for (int x = 0; x < core.columns(); x += 2) {
      const auto word = words[static_cast<std::size_t>(core.address(x, y))];
      const auto wanted = golden.pixel(x, y);
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        const int off = std::abs(static_cast<int>(word >> (10 - 5 * c) & 31) - wanted[c]);
        most = std::max(most, off);
        squares += off * off;
      }
      ++pixels;
      differing += most > 0;
      by_more += most > 1;
    }
  return {double(differing) / pixels, double(by_more) / pixels, std::sqrt(squares / pixels / 3)};
}

void expect_within(const SphereGoldenScene& scene, double by_more, double rmse) {
  const Difference d = difference(scene);
  EXPECT_LE(d.by_more, by_more) << d.differing << " differ, rmse " << d.rmse;
  EXPECT_LE(d.rmse, rmse);
  EXPECT_GT(d.differing, 0) << "the tracer is not in double precision";
}

TEST(SphereGolden, PlainPictureIsWithinAPercent) { expect_within(four(0, false, 1), 0.01, 1.5); }
TEST(SphereGolden, ReflectionsAreWithinAPercent) { expect_within(four(3, false, 1), 0.01, 1.5); }
TEST(SphereGolden, PlanesAreWithinOneAndAHalfPercent) {
  expect_within(four(0, true, 0), 0.015, 2.5);
}
TEST(SphereGolden, MirrorsOfPlanesAreWithinOneAndAHalfPercent) {
  expect_within(four(3, true, 0), 0.015, 2.8);
}
TEST(SphereGolden, SubRaysAreWithinAPercent) {
  SphereGoldenScene scene = four(0, false, 1);
  scene.sub_rays = 9;
  expect_within(scene, 0.01, 1.5);
}

}  // namespace
}  // namespace racebeam
