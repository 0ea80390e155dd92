// What the sphere tracer's pictures show, claim by claim of the report, pixel by pixel at tlm.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "sc/sphere/sphere_core.h"

namespace racebeam {
namespace {

constexpr int One = 4096, MiddleX = 256, MiddleY = 240;
constexpr sphere_colour White{31, 31, 31}, Red{31, 0, 0}, Green{0, 31, 0}, Black{0, 0, 0};

vec3 units(int x, int y, int z) { return {x * One, y * One, z * One}; }
plane_row floor_at(int y) { return {{0, -One, 0}, y * One, {29, 29, 29}, 0, 0, false, {}}; }
plane_row wall_at(int z, const sphere_colour& colour) {
  return {{0, 0, -One}, z * One, colour, 0, 0, false, {}};
}

/// Spheres, and planes if there are any, 512 x 480, from (0, 0, -32) along z; light at `light`.
class Picture {
 public:
  struct Scene {
    std::vector<sphere_row> spheres;
    std::vector<plane_row> planes{};
    int reflections = 0;
    vec3 light = sphere_start().light;
  };

  explicit Picture(const Scene& scene, const sphere_knobs& k = {})
      : tables_(tables_of(scene)), core_(k, tables_, board_of(scene)) {
    core_.load(scene.spheres);
  }

  std::vector<sphere_step> steps(int x, int y) const { return core_.explain(x, y); }
  std::uint64_t word(int x, int y) const { return steps(x, y).back().word; }
  /// 0..31.
  int red(int x, int y) const { return static_cast<int>(word(x, y) >> 10 & 31); }
  int times(int state, int x, int y) const {
    const auto all = steps(x, y);
    return static_cast<int>(std::count_if(
        all.begin(), all.end(), [state](const sphere_step& step) { return step.state == state; }));
  }

 private:
  static sphere_tables tables_of(const Scene& scene) {
    sphere_tables tables;
    tables.planes = scene.planes;
    tables.start.light = scene.light;
    return tables;
  }
  static sphere_board board_of(const Scene& scene) {
    constexpr int Size512 = 1 << 5, Key2 = 1 << 2;
    return {Size512 | scene.reflections << 2, scene.planes.empty() ? 15 : 15 & ~Key2};
  }

  const sphere_tables tables_;
  sphere_core core_;
};

/// Where the ray of a pixel meets a floor.
struct FloorPoint {
  FloorPoint(int x, int y, int floor)
      : px(double(floor) * (x - MiddleX) / (y - MiddleY)),
        pz(9 * 32.0 * floor / (y - MiddleY) - 32) {}
  /// Nearer to a whole number than a pixel's error.
  bool on_edge() const {
    return std::fabs(px - std::round(px)) < 0.03 || std::fabs(pz - std::round(pz)) < 0.03;
  }
  double px, pz;
};

TEST(SpherePicture, CheckerboardsHaveSquaresOf1248Units) {
  for (const int checker : {1, 2, 4, 8}) {
    plane_row floor = floor_at(22);
    floor.checker = checker;
    const Picture picture({{}, {floor}});
    int dark = 0, seen = 0;
    for (const int y : {400, 440})
      for (int x = 0; x < 512; ++x) {
        const FloorPoint at(x, y, 22);
        if (at.on_edge()) continue;
        const bool is_dark = (static_cast<int>(std::floor(at.px)) & checker) !=
                             (static_cast<int>(std::floor(at.pz)) & checker);
        ASSERT_EQ(picture.red(x, y), is_dark ? 7 : 28) << x << "," << y << " checker " << checker;
        dark += is_dark;
        ++seen;
      }
    EXPECT_GT(seen, 500);
    EXPECT_NEAR(dark, seen / 2, seen / 10);
  }
}

TEST(SpherePicture, PlanesEndAtTheirBounds) {
  plane_row floor = floor_at(22);
  floor.limited = true;
  floor.limit = {9, 30, 10};
  const Picture picture({{}, {floor}});
  const auto expect = [&](int x, int y) {
    const FloorPoint at(x, y, 22);
    if (at.on_edge()) return 0;
    const bool within = std::fabs(at.px) < 9 && std::fabs(at.pz) < 10;
    EXPECT_EQ(picture.red(x, y), within ? 28 : 0) << x << "," << y;
    return within ? 1 : 0;
  };
  int within = 0;
  for (int x = 0; x < 512; ++x) within += expect(x, 440);
  EXPECT_GT(within, 100);
  within = 0;
  for (int y = 260; y < 480; ++y) within += expect(MiddleX + 3, y);
  EXPECT_GT(within, 50);
}

TEST(SpherePicture, NearestPlaneIsSeenInAnyOrderOfTheTable) {
  plane_row near = wall_at(20, Red);
  near.limited = true;
  near.limit = {3, 3, 30};
  const plane_row far = wall_at(40, Green);
  for (const auto& planes : {std::vector<plane_row>{near, far}, {far, near}}) {
    const Picture picture({{}, planes});
    EXPECT_EQ(picture.word(MiddleX + 10, MiddleY), 30u << 10) << "1.8 units aside";
    EXPECT_EQ(picture.word(MiddleX + 30, MiddleY), 30u << 5) << "5.4 units aside";
  }
}

TEST(SpherePicture, PlanesAreTestedByRaysThatMissAllSpheres) {
  Picture::Scene scene{{sphere_row::of(units(0, 0, 15), 5, White, 0x800)}, {wall_at(40, Red)}};
  EXPECT_EQ(Picture(scene).times(SpherePlane, MiddleX, MiddleY), 0);
  EXPECT_EQ(Picture(scene).times(SpherePlane, 0, MiddleY), 1);
  scene.reflections = 1;
  EXPECT_EQ(Picture(scene).times(SpherePlane, MiddleX, MiddleY), 1) << "the mirrored ray";
}

/// Two spheres that touch, the light beside them; a pixel of the left one beside the right one.
struct Touching {
  static constexpr int X = 282, Y = 240;
  Picture::Scene scene{
      {sphere_row::of(units(0, 0, 15), 5, White, 0), sphere_row::of(units(10, 0, 15), 5, White, 0),
       sphere_row::of(units(0, 60, 15), 5, White, 0)},
      {},
      0,
      units(20, 0, 15)};
};

TEST(SpherePicture, OneOfTwoTouchingSpheresShadesTheOther) {
  Touching t;
  const Picture both(t.scene);
  EXPECT_EQ(both.red(t.X, t.Y), 15) << "half the colour";
  EXPECT_EQ(both.times(SphereShadowCentre, t.X, t.Y), 2) << "the third sphere is not asked";
  t.scene.spheres[1] = t.scene.spheres[2];
  EXPECT_GT(Picture(t.scene).red(t.X, t.Y), 25);
}

TEST(SpherePicture, SphereBeyondTheLightCastsNoShadow) {
  Touching t;
  t.scene.spheres[1] = sphere_row::of(units(30, 0, 15), 5, White, 0);
  const Picture beyond(t.scene);
  EXPECT_GT(beyond.red(t.X, t.Y), 25);
  EXPECT_EQ(beyond.times(SphereShadowAlong, t.X, t.Y), 3) << "each sphere, and not the light";
}

TEST(SpherePicture, LightIsWhiteInAMirrorAndEndsTheRay) {
  const Picture picture(
      {{sphere_row::of(units(0, 0, 15), 5, Black, 0xfff)}, {}, 3, units(0, -20, -10)});
  int seen = 0;
  for (int y = MiddleY - 30; y < MiddleY; ++y) {
    const auto steps = picture.steps(MiddleX, y);
    const auto light = std::find_if(steps.begin(), steps.end(), [](const sphere_step& step) {
      return step.what == "the light";
    });
    if (light == steps.end()) continue;
    ++seen;
    EXPECT_EQ(steps.back().word, 0x7fffu) << "without the bit of the light itself, row " << y;
    ASSERT_EQ(steps.end() - light, 3) << "LIGHT, ADD, NEXT";
  }
  EXPECT_GT(seen, 1);
}

TEST(SpherePicture, NormalTakesOneClockWhereADivisionTakesSix) {
  Picture::Scene scene{{sphere_row::of(units(0, 0, 15), 5, White, 0)}, {floor_at(22)}};
  sphere_knobs slow;
  slow.divide_clocks = 36;
  for (const sphere_knobs& k : {sphere_knobs(), slow}) {
    const Picture picture(scene, k);
    for (const int y : {MiddleY, 440}) {  // the sphere; the floor, whose normal is stored
      int normal = 0, divide = 0;
      for (const sphere_step& step : picture.steps(MiddleX, y)) {
        normal += step.state == SphereNormal ? step.clocks : 0;
        divide += step.state == SphereLdivide ? step.clocks : 0;
      }
      EXPECT_EQ(normal, 1);
      EXPECT_EQ(divide, k.divide_clocks + 1);
    }
  }
}

/// Across a sphere of this colour along a row.
struct Rings {
  explicit Rings(int colour, int bits = 5) {
    sphere_knobs k;
    k.colour_bits = bits;
    const Picture picture({{sphere_row::of(units(0, 0, 40), 20, {colour, colour, colour}, 0)}}, k);
    const std::uint64_t mask = (1u << bits) - 1;
    std::uint64_t last = 0;
    for (int x = 0; x < 512; ++x) {
      const std::uint64_t level = picture.word(x, MiddleY) & mask;
      if (level == 0) continue;
      levels.insert(level);
      rings += level != last;
      last = level;
      ++pixels;
    }
  }
  std::set<std::uint64_t> levels;
  int rings = 0, pixels = 0;
};

TEST(SpherePicture, ShadesAcrossASphereAreRings) {
  for (int colour = 1; colour < 32; ++colour) {
    const Rings across(colour);
    EXPECT_LE(across.levels.size(), 32u);
    EXPECT_GE(*across.levels.begin(), static_cast<unsigned>(colour - 1) / 2) << "facing away";
  }
  const Rings white(31);
  EXPECT_EQ(white.levels.size(), 17u) << "15..31";
  EXPECT_EQ(white.rings, 23);
  EXPECT_EQ(white.pixels, 167) << "7 a ring";
  EXPECT_EQ(Rings(31, 4).levels.size(), 9u);
  EXPECT_EQ(Rings(31, 6).levels.size(), 34u) << "a bit more makes twice as many";
}

TEST(SpherePicture, ReflectionsEndByNumberOrWeight) {
  const std::vector<plane_row> mirrors = {wall_at(40, Black),
                                          {{0, 0, One}, 40 * One, Black, 0, 0, false, {}}};
  for (int n = 0; n <= 3; ++n) {
    auto planes = mirrors;
    for (plane_row& plane : planes) plane.reflect = 0xfff;
    EXPECT_EQ(Picture({{}, planes, n}).times(SphereReflect, MiddleX + 9, MiddleY), n);
    for (plane_row& plane : planes) plane.reflect = 0x200;  // its square is 64 of 4096
    EXPECT_EQ(Picture({{}, planes, n}).times(SphereReflect, MiddleX + 9, MiddleY), std::min(n, 2));
  }
  for (const int reflect : {40, 41}) {  // the first weight is 4095 of 4096
    auto planes = mirrors;
    planes[0].reflect = reflect;
    EXPECT_EQ(Picture({{}, planes, 3}).times(SphereReflect, MiddleX + 9, MiddleY), reflect > 40);
  }
}

TEST(SpherePicture, ReflectionsShowBestOnDarkSpheres) {
  const auto contrast = [](int colour) {
    Picture::Scene scene{{sphere_row::of(units(0, 0, 15), 5, {colour, colour, colour}, 0x800)},
                         {floor_at(22)}};
    const Picture plain(scene);
    scene.reflections = 1;
    const Picture mirror(scene);
    int without = 0, with = 0;
    for (int y = MiddleY + 5; y < MiddleY + 30; y += 5)
      for (int x = MiddleX - 20; x <= MiddleX + 20; x += 5) {
        EXPECT_GE(mirror.red(x, y), plain.red(x, y));
        without += plain.red(x, y);
        with += mirror.red(x, y);
      }
    return double(with - without) / without;
  };
  const double dark = contrast(4), bright = contrast(24);
  EXPECT_GT(dark, 2.5);
  EXPECT_LT(bright, 0.25);
}

// what a faster root would give
TEST(SpherePicture, EveryRootTakesTheClocksOfItsKnob) {
  const auto counted = [](int bits) {
    sphere_knobs k;
    k.root_bits_per_clock = bits;
    const sphere_tables tables;
    const sphere_board narrow{0, 15};
    sphere_core core(k, tables, narrow);
    core.load(builtin_spheres(false));
    core.draw(narrow);
    return core.counters();
  };
  const sphere_counters usual = counted(6);
  EXPECT_EQ(usual.buffer_stalls, 0u);
  EXPECT_EQ(counted(22).clocks, usual.clocks - 3 * usual.roots);
  EXPECT_EQ(counted(1).clocks, usual.clocks + 18 * usual.roots);
}

}  // namespace
}  // namespace racebeam
