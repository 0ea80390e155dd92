// Promises of sc/sphere/sphere_tracer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sphere/four_scene.h"
#include "tests/sphere/sphere_tracer_bench.h"
#include "tests/sphere/twins.h"
#include "tests/support/four_pixels.h"

namespace racebeam {
namespace {

template <class Unit>
class SphereTracerTest : public testing::Test {};
TYPED_TEST_SUITE(SphereTracerTest, sphere_twins<sphere_tracer>);

constexpr int One = 4096;

template <class Unit>
void expect_mode(int mode) {
  TracerBench<Unit> b({}, four_spheres(), four_tables().planes);
  set_mode(b.inputs, mode);
  for (const four_pixel& p : FourPixels) {
    EXPECT_EQ(b.pixel(p.x, p.y), p.by_mode[mode].clocks) << p.x << "," << p.y;
    EXPECT_EQ(b.word, p.by_mode[mode].word) << p.x << "," << p.y;
  }
}
TYPED_TEST(SphereTracerTest, PlainPixelsOfFour) { expect_mode<TypeParam>(0); }
TYPED_TEST(SphereTracerTest, PixelsOfFourWithReflections) { expect_mode<TypeParam>(1); }
TYPED_TEST(SphereTracerTest, PixelsOfFourWithPlanes) { expect_mode<TypeParam>(2); }
TYPED_TEST(SphereTracerTest, PixelsOfFourWithPlanesAndSubRays) { expect_mode<TypeParam>(3); }

TYPED_TEST(SphereTracerTest, NothingButTheLightTakes19Clocks) {
  TracerBench<TypeParam> b({}, {}, {});
  EXPECT_EQ(b.pixel(0, 0), 19);
}

TYPED_TEST(SphereTracerTest, OneSphereMissedTakes23Clocks) {
  TracerBench<TypeParam> b({}, {sphere_row::of({0, 0, 15 * One}, 5, {31, 0, 0}, 0)}, {});
  EXPECT_EQ(b.pixel(0, 0), 23);
}

TYPED_TEST(SphereTracerTest, EyeInTheFirstSphereTakes17ClocksAndIsBlack) {
  TracerBench<TypeParam> b({}, {sphere_row::of({0, 0, -32 * One}, 5, {31, 31, 31}, 0)}, {});
  EXPECT_EQ(b.pixel(256, 240), 17);
  EXPECT_EQ(b.word, 0u);
  EXPECT_EQ(b.states.back(), SphereNext);
  EXPECT_EQ(b.states[15], SphereAlong);
}

TYPED_TEST(SphereTracerTest, StatesOfALitHitInTheirOrder) {
  TracerBench<TypeParam> b({}, {sphere_row::of({0, 0, 15 * One}, 5, {31, 0, 0}, 0)}, {});
  b.pixel(256, 240);
  std::vector<int> order = b.states;
  order.erase(std::unique(order.begin(), order.end()), order.end());
  EXPECT_EQ(order, (std::vector<int>{
                       SphereRay,          SphereRoot,        SphereDivide,      SphereCentre,
                       SphereAlong,        SphereFront,       SphereChord,       SphereWait,
                       SphereHit,          SphereCentre,      SphereAlong,       SphereFront,
                       SphereChord,        SphereLight,       SphereLray,        SphereLroot,
                       SphereLdivide,      SphereNormal,      SphereLambert,     SphereShade,
                       SphereShadowCentre, SphereShadowAlong, SphereShadowFront, SphereShadowCentre,
                       SphereAdd,          SphereNext}));
  const auto clocks = [&b](int state) {
    return std::count(b.states.begin(), b.states.end(), state);
  };
  EXPECT_EQ(clocks(SphereRoot), 7);
  EXPECT_EQ(clocks(SphereLroot), 7);
  EXPECT_EQ(clocks(SphereDivide), 6);
  EXPECT_EQ(clocks(SphereLdivide), 6);
  EXPECT_EQ(clocks(SphereHit), 6);
}

TYPED_TEST(SphereTracerTest, RootsAndDivisionsOfOtherClocksAreWaitedFor) {
  sphere_knobs k;
  k.root_bits_per_clock = 22;
  k.divide_clocks = 9;
  TracerBench<TypeParam> b(k, {}, {});
  EXPECT_EQ(b.pixel(0, 0), 1 + 4 + 10 + 4 + 1);
}

TYPED_TEST(SphereTracerTest, NearestOfThreeIsSeenInAnyOrderOfTheTable) {
  std::vector<sphere_row> spheres = {sphere_row::of({0, 0, 15 * One}, 5, {31, 0, 0}, 0),
                                     sphere_row::of({One, 0, 12 * One}, 5, {0, 31, 0}, 0),
                                     sphere_row::of({0, One, 18 * One}, 5, {0, 0, 31}, 0)};
  TracerBench<TypeParam> b({}, spheres, {});
  b.pixel(256, 250);
  const auto seen = b.word;
  EXPECT_NE(seen, 0u);
  int order[3] = {0, 1, 2};
  do {
    for (int n = 0; n < 3; ++n) b.table.clock({true, n, 3, spheres[order[n]]}, {});
    b.pixel(256, 250);
    EXPECT_EQ(b.word, seen);
  } while (std::next_permutation(order, order + 3));
}

TYPED_TEST(SphereTracerTest, FullBufferHoldsTheWord) {
  TracerBench<TypeParam> b({}, {}, {});
  b.bench["word_ready_i"].drive(0);
  for (int n = 0; n < 30; ++n) b.clock();
  b.settle();
  EXPECT_EQ(b.value("state_o"), SphereNext);
  EXPECT_EQ(b.value("word_valid_o"), 1);
  EXPECT_EQ(b.value("shader_op_o"), ShadeHold);
  EXPECT_EQ(b.value("word_address_o"), 0);
  b.bench["word_ready_i"].drive(1);
  b.settle();
  EXPECT_EQ(b.value("shader_op_o"), ShadeStore);
  b.clock();
  b.settle();
  EXPECT_EQ(b.value("state_o"), SphereRay);
  EXPECT_EQ(b.value("word_address_o"), 1);
}

TYPED_TEST(SphereTracerTest, EachPassIsWrittenIfAskedFor) {
  sphere_knobs k;
  k.write_each_pass = 1;
  TracerBench<TypeParam> b(k, four_spheres(), {});
  set_mode(b.inputs, 1);
  EXPECT_EQ(b.pixel(200, 240), 109);
  EXPECT_EQ(b.offers, 2) << "the sphere, and its reflection that meets nothing";
  EXPECT_EQ(b.word, 0x7863u);
}

TYPED_TEST(SphereTracerTest, WithoutShadowRaysNoSphereIsTestedFromAHit) {
  sphere_knobs k;
  k.shadow_rays = 0;
  TracerBench<TypeParam> b(k, four_spheres(), {});
  b.pixel(200, 240);
  EXPECT_EQ(std::count(b.states.begin(), b.states.end(), SphereShadowAlong), 0);
  EXPECT_EQ(std::count(b.states.begin(), b.states.end(), SphereShadowCentre), 1);
}

TYPED_TEST(SphereTracerTest, PlaneBetweenPointAndLightCastsAShadowIfAskedFor) {
  // A sphere lit from the right, and a wall on the way that is seen from the sphere's side only.
  const std::vector<sphere_row> spheres = {sphere_row::of({0, 0, 15 * One}, 5, {31, 31, 31}, 0)};
  const std::vector<plane_row> wall = {{{-One, 0, 0}, 10 * One, {31, 0, 0}, 0, 0, false, {}}};
  sphere_knobs k;
  TracerBench<TypeParam> b(k, spheres, wall);
  b.inputs.planes_q = true;
  b.pixel(270, 250);
  const auto lit = b.word;
  EXPECT_EQ(std::count(b.states.begin(), b.states.end(), SpherePlane), 0);
  EXPECT_GT(lit & 31, 16u);
}

TYPED_TEST(SphereTracerTest, PlaneShadowIsHalfTheColour) {
  const std::vector<sphere_row> spheres = {sphere_row::of({0, 0, 15 * One}, 5, {31, 31, 31}, 0)};
  const std::vector<plane_row> wall = {{{-One, 0, 0}, 10 * One, {31, 0, 0}, 0, 0, false, {}}};
  sphere_knobs k;
  k.plane_shadows = 1;
  TracerBench<TypeParam> b(k, spheres, wall);
  b.inputs.planes_q = true;
  b.pixel(270, 250);
  EXPECT_EQ(std::count(b.states.begin(), b.states.end(), SpherePlaneT), 6);
  EXPECT_EQ(b.word & 31, 15u);
}

TYPED_TEST(SphereTracerTest, EveryStateLeadsToHostAtReset) {
  TracerBench<TypeParam> b({}, four_spheres(), four_tables().planes);
  set_mode(b.inputs, 2);
  for (int clocks = 1; clocks < 200; clocks += 13) {
    for (int n = 0; n < clocks; ++n) b.clock();
    b.bench["rst_ni"].drive(0);
    b.clock();
    b.settle();
    ASSERT_EQ(b.value("state_o"), SphereHost);
    ASSERT_EQ(b.value("done_o"), 1);
    ASSERT_EQ(b.value("root_start_o"), 0);
    b.bench["rst_ni"].drive(1);
    b.bench["loaded_i"].drive(1);
    b.clock();
    b.bench["loaded_i"].drive(0);
  }
}

}  // namespace
}  // namespace racebeam
