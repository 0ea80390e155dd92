// The golden camera and the golden world, held to the vectors of the contract and the article's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tb/golden/golden_world.h"
#include "tb/golden/tracer_4.h"
#include "tb/show/demo_parts.h"

namespace racebeam {
namespace {

struct Vector {
  int frame, y;
  vec3 dr_0, ddr;
};

// Contract 20.1.
TEST(GoldenCamera, MeetsTheCameraVectors) {
  const Vector vectors[] = {
      {2, -240, {-319, -239, 95}, {511, 0, 0}},
      {2, 239, {-319, 239, 97}, {511, 0, 0}},
      {700, -100, {-145, -141, 302}, {272, 0, -461}},
      {700, 239, {29, 157, 405}, {272, 0, -461}},
      {1400, -239, {50, -213, 375}, {-307, 0, -442}},
      {1400, 0, {236, -87, 247}, {-307, 0, -442}},
      {4700, 100, {-323, -43, 178}, {333, 0, -426}},
      {8754, -100, {-128, -178, 338}, {358, 0, -407}},
      {8754, 239, {-127, 217, 340}, {358, 0, -407}},
      {9100, 0, {90, -136, 348}, {107, 0, -504}},
  };
  for (const Vector& v : vectors) {
    const GoldenCamera camera(v.frame);
    const GoldenLine line = golden_line(camera.view(v.y), v.y);
    EXPECT_EQ(line.dr_0, v.dr_0) << v.frame << " " << v.y;
    EXPECT_EQ(line.ddr, v.ddr) << v.frame << " " << v.y;
    EXPECT_EQ(camera.rays(v.y)[0], v.dr_0);
  }
}

// The article's arithmetic ("Avoiding storage of fractional bits"), in units of 1/256 there and of
// 1/512 here.
TEST(GoldenCamera, StepsMeetTheArticlesVectors) {
  struct {
    int delta, i, sum;
  } const vectors[] = {{43, 43, 6},     {171, 213, 144},   {-341, 213, -282}, {-469, 43, -80},
                       {205, 639, 512}, {-205, 639, -512}, {409, 320, 511}};
  for (const auto& v : vectors) EXPECT_EQ(golden_steps(2 * v.delta, v.i), v.sum) << v.delta;
}

TEST(GoldenCamera, RaysAreThoseOfTheSteps) {
  for (const int frame : {700, 2400, 8500, 9500, 10000}) {
    const GoldenCamera camera(frame);
    const GoldenLine line = golden_line(camera.view(17), 17);
    const GoldenRays rays = camera.rays(17);
    for (int p = 0; p < VisibleColumns; ++p)
      for (int a = 0; a < 3; ++a)
        ASSERT_EQ(rays[p][a], wrap_signed(line.dr_0[a] + golden_steps(line.ddr[a], p), 10)) << p;
  }
}

TEST(GoldenCamera, FastAndTwistedViews) {
  const auto expect_view = [](int frame, int y, int yaw, int pitch, int fov) {
    const GoldenView view = GoldenCamera(frame).view(y);
    EXPECT_EQ(view.yaw, 2 * yaw) << frame;  // the demo counts 1/1024 turn
    EXPECT_EQ(view.pitch, 2 * pitch) << frame;
    EXPECT_EQ(view.fov, fov) << frame;
  };
  expect_view(700, 5, 175, 1023 - 87, 96);
  expect_view(9500, 5, (9500 + 5) % 1024, (2 * 1024 + 4095 - 4750 + 5 - 1024) % 1024, 96);  // fast
  expect_view(9650, -7, (9650 - 14) % 1024, 1023 - (4825 + 14) % 1024, 96);  // fast, double
  expect_view(8400, 20, 2100 % 1024 + 20, 1023 - 1050 % 1024, 96);
  expect_view(9000, 0, 2250 % 1024, 1023 - 1125 % 1024, 4500 % 256);
  expect_view(8750, 9, 2187 % 1024, 1023 - 1093 % 1024, (4375 + 9) % 256);
}

// The chip has 511 for one and rounds every product down: a few units of 512.
TEST(GoldenCamera, IntegerRaysAreNearTheIdeal) {
  double sum = 0;
  int count = 0;
  for (const DemoPart& part : demo_parts()) {
    const GoldenCamera camera((part.first_frame + part.last_frame) / 2);
    for (int y = -240; y < 240; y += 7) {
      const GoldenRays rays = camera.rays(y);
      const GoldenIdeal ideal = camera.ideal(y);
      for (int p = 0; p < VisibleColumns; p += 13)
        for (int a = 0; a < 3; ++a) {
          const double want = ideal.ray(p)[a];
          if (std::abs(want) > 480) continue;  // may wrap
          ASSERT_NEAR(rays[p][a], want, 6) << part.first_frame << " line " << y << " pixel " << p;
          sum += std::abs(rays[p][a] - want), ++count;
        }
    }
  }
  EXPECT_LT(sum / count, 1);
}

// Article "Camera view calculations": cos(pi/2 t) is about (1 - t)(1 + t).
TEST(GoldenCamera, ParabolasAreUpTo0056TooLargeAndNeverTooSmall) {
  double least = 1, most = -1;
  for (int yaw = 0; yaw <= 512; ++yaw) {
    const double parabola = GoldenIdeal({yaw, 0, 96}, 0).ddr[0];
    const double exact = GoldenIdeal({yaw, 0, 96}, 0, CosineExact).ddr[0];
    ASSERT_NEAR(exact, std::cos(std::acos(0.0) * yaw / 512), 1e-12);
    least = std::min(least, parabola - exact);
    most = std::max(most, parabola - exact);
  }
  EXPECT_NEAR(least, 0, 1e-12);
  EXPECT_NEAR(most, 0.0560, 0.00005);
}

TEST(GoldenCamera, ExactIntegerRaysAreNearTheExactIdeal) {
  knobs k;
  k.camera_cosine = CosineExact;
  for (const DemoPart& part : demo_parts()) {
    const GoldenCamera camera((part.first_frame + part.last_frame) / 2, k);
    for (int y = -240; y < 240; y += 29) {
      const GoldenRays rays = camera.rays(y);
      const GoldenIdeal ideal = camera.ideal(y);
      for (int p = 0; p < VisibleColumns; p += 13)
        for (int a = 0; a < 3; ++a) {
          const double want = ideal.ray(p)[a];
          if (std::abs(want) > 480) continue;  // may wrap
          ASSERT_NEAR(rays[p][a], want, 6) << part.first_frame << " line " << y << " pixel " << p;
        }
    }
  }
}

// An opening is in the plane where two boxes meet; only the tunnel has copies beside a room.
TEST(GoldenWorld, NeighboursTouchInThePlaneOfTheirFace) {
  for (const DemoPart& part : demo_parts()) {
    const GoldenWorld world((part.first_frame + part.last_frame) / 2, {});
    std::set<std::array<int, 3>> places;
    for (const GoldenRoom& room : world.rooms) {
      places.insert(room.position);
      for (int axis = 0; axis < 3; ++axis)
        for (const bool negative : {false, true})
          for (const int next : room.neighbours[golden_face(axis, negative)]) {
            const GoldenRoom& beyond = world.rooms.at(next);
            if (beyond.position == room.position) continue;
            const int way = negative ? -1 : 1;
            ASSERT_EQ(room.position[axis] + way * room.half_size[axis],
                      beyond.position[axis] - way * beyond.half_size[axis])
                << part.first_frame;
          }
    }
    EXPECT_GT(places.size(), 10u) << part.first_frame;
  }
}

TEST(GoldenWorld, TheTunnelIsOneSpacePastItsLastRoom) {
  const GoldenWorld world(5119, {});
  int low = 0, high = 0;
  for (const GoldenRoom& room : world.rooms) {
    low = std::min(low, room.position[2]);
    high = std::max(high, room.position[2]);
  }
  EXPECT_EQ(high - low, 16 * 256) << "eight rooms to either side";
}

// Contract 20.2: closest powers of two; the switch is found wherever it is.
TEST(GoldenSwitch, FindsEverySwitch) {
  for (const int rule : {BisectionPow2, BisectionMidpoint, BisectionFloor})
    for (int right = 1; right < 640; right += right < 20 ? 1 : 37)
      for (int last = 0; last < right; ++last)
        ASSERT_EQ(golden_switch(0, right, rule, [&](int p) { return p <= last; }), last);
}

TEST(GoldenSwitch, ProbesAsTheContractsTrace) {
  std::vector<int> probes;
  EXPECT_EQ(golden_switch(0, 639, BisectionPow2,
                          [&](int p) {
                            probes.push_back(p);
                            return p <= 318;
                          }),
            318);
  EXPECT_EQ(probes, (std::vector<int>{383, 255, 319, 287, 303, 311, 315, 317, 318}));
}

}  // namespace
}  // namespace racebeam
