// Promises of tb/host/sphere_motion.h: the motion vectors of the design.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace racebeam {
namespace {

MovingSphere moving(const Vector3& centre, const Vector3& velocity, int radius) {
  MovingSphere s;
  s.centre = centre;
  s.velocity = velocity;
  s.radius = radius;
  return s;
}

void expect_near(const Vector3& at, const Vector3& wanted, double within = 0.00006) {
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(at[n], wanted[n], within) << "axis " << n;
}

SphereMotion three() {
  return SphereMotion(
      {moving({-9, 0, 15}, {0.5, 0.125, 0}, 5), moving({9, 0.5, 15}, {-0.25, 0, 0.0625}, 5),
       moving({0, -9, 20}, {0, 0.375, -0.125}, 4)},
      {});
}

TEST(SphereMotion, FourteenPicturesHaveOneCollision) {
  SphereMotion m = three();
  for (int n = 0; n < 14; ++n) m.picture();
  EXPECT_EQ(m.collisions(), 1);
  expect_near(m.spheres()[0].centre, {-3.2309, 3.5964, 13.9400});
  expect_near(m.spheres()[1].centre, {5.5, 0.5, 15.875});
  expect_near(m.spheres()[2].centre, {1.2309, -5.5964, 19.3100});
  EXPECT_EQ(m.spheres()[0].counter, 12);
  EXPECT_EQ(m.spheres()[1].counter, 0);
  EXPECT_EQ(m.spheres()[2].counter, 26);
}

TEST(SphereMotion, SixHundredPicturesHaveEightCollisionsAndStayInTheBox) {
  SphereMotion m = three();
  for (int n = 0; n < 600; ++n) {
    m.picture();
    for (const MovingSphere& s : m.spheres())
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_GE(s.centre[k], MotionBox().low[k]);
        ASSERT_LE(s.centre[k], MotionBox().high[k]);
      }
  }
  EXPECT_EQ(m.collisions(), 8);
  expect_near(m.spheres()[0].centre, {-11.9884, 8.7985, 8.6809});
}

int collisions_with(int guard) {
  SphereMotion m({moving({-3, 0, 20}, {0.3, 0.02, 0}, 3), moving({3.1, 0, 20}, {-0.3, 0, 0}, 3),
                  moving({0, 5.5, 20}, {0, -0.4, 0.01}, 3)},
                 {}, guard);
  for (int n = 0; n < 600; ++n) m.picture();
  return m.collisions();
}

TEST(SphereMotion, CounterKeepsSpheresFromCapturingEachOther) {
  EXPECT_EQ(collisions_with(GuardCounter), 5);
  EXPECT_EQ(collisions_with(GuardOff), 73);
}

TEST(SphereMotion, ApproachLetsOnlySpheresThatComeNearerCollide) {
  EXPECT_LT(collisions_with(GuardApproach), collisions_with(GuardOff));
}

TEST(SphereMotion, WallIsReachedBeforeTheVelocityTurns) {
  SphereMotion m({moving({14.9, 0, 20}, {0.5, 0, 0}, 2)}, {});
  m.picture();
  expect_near(m.spheres()[0].centre, {15, 0, 20});
  m.picture();
  expect_near(m.spheres()[0].centre, {14.5, 0, 20});
}

TEST(SphereMotion, TurnAroundZIsTheVectorOfTheDesign) {
  SphereMotion m({moving({9, 0.5, 15}, {}, 5)}, {});
  m.picture(1 << 5);
  expect_near(m.spheres()[0].centre, {8.964625, 0.941007, 15}, 5e-7);
  EXPECT_EQ(m.table()[0].centre, (vec3{0x8f6f, 0xf0e, 0xf000}));
  m.picture(1 << 4);
  expect_near(m.spheres()[0].centre, {9, 0.5, 15}, 1e-12);
}

TEST(SphereMotion, EachTurnGoesBackWithItsOther) {
  for (const int pair : {5, 3, 1}) {
    SphereMotion m({moving({3, 5, 15}, {}, 5)}, {});
    m.picture(1 << pair);
    const auto turned = m.spheres()[0].centre;
    EXPECT_NEAR(std::hypot(turned[0], turned[1], turned[2]), std::hypot(3, 5, 15), 1e-12);
    EXPECT_EQ(turned[pair == 5 ? 2 : pair == 3 ? 0 : 1], pair == 5 ? 15 : pair == 3 ? 3 : 5);
    m.picture(1 << (pair - 1));
    expect_near(m.spheres()[0].centre, {3, 5, 15}, 1e-12);
  }
}

TEST(SphereMotion, TableHasWholeRadiiAndTheirInverse) {
  SphereMotion m({moving({-9, 0, 15}, {}, 5)}, {});
  const sphere_row row = m.table()[0];
  EXPECT_EQ(row.centre, (vec3{-9 * 4096, 0, 15 * 4096}));
  EXPECT_EQ(row.radius2, 25);
  EXPECT_EQ(row.inverse, 819);
}

}  // namespace
}  // namespace racebeam
