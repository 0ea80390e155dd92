// Promises of sc/sphere/sphere_raygen.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_raygen.h"

#include <gtest/gtest.h>

#include "sc/sphere/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const sphere_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.drive("origin", "_i", {0, 0, -32 * 4096});
    bench["screen_i"].drive(8 * 4096);
  }
  vec3 at(unsigned x, unsigned y, unsigned sub = 0) {
    bench["x_i"].drive(x);
    bench["y_i"].drive(y);
    bench["sub_i"].drive(sub);
    bench.settle();
    return bench.read("direction");
  }
};

template <class Unit>
class SphereRaygenTest : public testing::Test {};
TYPED_TEST_SUITE(SphereRaygenTest, sphere_twins<sphere_raygen>);

vec3 raw(int x, int y, int z) { return wrap24(x, y, z); }

TYPED_TEST(SphereRaygenTest, DirectionsOfFourPixels) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.at(0, 0), raw(0xff8000, 0xff8800, 0x009000));
  EXPECT_EQ(d.at(200, 240), raw(0xffe400, 0x000000, 0x009000));
  EXPECT_EQ(d.at(396, 380), raw(0x004600, 0x004600, 0x009000));
  EXPECT_EQ(d.at(100, 400), raw(0xffb200, 0x005000, 0x009000));
}

TYPED_TEST(SphereRaygenTest, SubRaysAreHalfAPixelAside) {
  Dut<TypeParam> d;
  const vec3 middle = d.at(256, 240);
  const int offsets[][2] = {{0, 0},  {-1, -1}, {-1, 1}, {1, -1}, {1, 1},
                            {-1, 0}, {0, 1},   {0, -1}, {1, 0},  {0, 0}};
  for (unsigned sub = 0; sub < 10; ++sub)
    EXPECT_EQ(d.at(256, 240, sub),
              raw(middle[0] + 64 * offsets[sub][0], middle[1] + 64 * offsets[sub][1], middle[2]))
        << sub;
}

TYPED_TEST(SphereRaygenTest, NarrowPictureHasItsMiddleAt160And120) {
  Dut<TypeParam> d;
  d.bench["narrow_i"].drive(1);
  EXPECT_EQ(d.at(160, 120), raw(0, 0, 0x9000));
}

TYPED_TEST(SphereRaygenTest, EyeIsShiftedArithmetically) {
  Dut<TypeParam> d;
  d.bench.drive("origin", "_i", {-33, 95, -1});
  EXPECT_EQ(d.at(256, 240), raw(2, -2, 8 * 4096 + 1));
}

TYPED_TEST(SphereRaygenTest, WidePictureHasItsMiddleAt320) {
  sphere_knobs k;
  k.wide = 1;
  Dut<TypeParam> d(k);
  EXPECT_EQ(d.at(320, 240), raw(0, 0, 0x9000));
  EXPECT_EQ(d.at(639, 479), raw(319 * 128, 239 * 128, 0x9000));
  d.bench["narrow_i"].drive(1);
  EXPECT_EQ(d.at(160, 120), raw(0, 0, 0x9000));
}

}  // namespace
}  // namespace racebeam
