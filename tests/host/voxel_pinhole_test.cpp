// The rays of a pinhole, beside the same in plain numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_pinhole.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace racebeam {
namespace {

using testing::ElementsAre;

constexpr vec3 World{512, 256, 128};
constexpr double One = 1 << 24;

/// The ray of a pixel, as the tracer adds it up.
Vector3 ray(const voxel_view& view, int x, int y) {
  Vector3 d;
  for (std::size_t k = 0; k < 3; ++k)
    d[k] = view.d00[k] + double(x) * view.dx[k] + double(y) * view.dy[k];
  return d;
}

/// As long as a vector whose largest component is 1.
Vector3 reduced(const Vector3& v) {
  double most = 0;
  for (const double each : v) most = std::max(most, std::abs(each));
  return {v[0] / most, v[1] / most, v[2] / most};
}

TEST(VoxelPinholeTest, LooksNorthWithoutAngles) {
  VoxelPinhole at;
  at.focal_length = 320;
  const voxel_view view = pinhole_view(at, 640, 480, World);
  const Vector3 middle = reduced(ray(view, 320, 240)), right = reduced(ray(view, 639, 240)),
                low = reduced(ray(view, 320, 479));
  EXPECT_THAT(middle, ElementsAre(testing::DoubleNear(0, 1e-4), 1, testing::DoubleNear(0, 1e-4)));
  EXPECT_NEAR(right[0] / right[1], 319 / 320.0, 1e-4);
  EXPECT_NEAR(low[2] / low[1], -239 / 320.0, 1e-4);
}

TEST(VoxelPinholeTest, TurnsToTheRightAndDown) {
  VoxelPinhole at;
  at.yaw = 512;  // a quarter
  Vector3 middle = reduced(ray(pinhole_view(at, 640, 480, World), 320, 240));
  EXPECT_NEAR(middle[0], 1, 1e-4);
  at.yaw = 0;
  at.pitch = 256;  // an eighth
  middle = reduced(ray(pinhole_view(at, 640, 480, World), 320, 240));
  EXPECT_NEAR(middle[1], 1, 1e-4);
  EXPECT_NEAR(middle[2], -1, 1e-4);
}

TEST(VoxelPinholeTest, IsSpannedByThreeVectorsAtRightAngles) {
  VoxelPinhole at;
  at.yaw = 300;
  at.pitch = 150;
  at.focal_length = 200;
  const voxel_view view = pinhole_view(at, 512, 480, World);
  const Vector3 right = ray({{}, {}, view.dx, view.dy}, 1, 0),
                down = ray({{}, {}, view.dx, view.dy}, 0, 1), forward = ray(view, 256, 240);
  const double unit = std::sqrt(dot(right, right));
  EXPECT_NEAR(std::sqrt(dot(down, down)), unit, 2);
  EXPECT_NEAR(std::sqrt(dot(forward, forward)) / unit, 200, 0.02);
  EXPECT_NEAR(dot(right, down) / unit / unit, 0, 1e-4);
  EXPECT_NEAR(dot(right, forward) / unit / unit, 0, 0.02);
  EXPECT_NEAR(dot(down, forward) / unit / unit, 0, 0.02);
  // Right, forward and up are a right hand's.
  EXPECT_GT(right[0] * forward[1] - right[1] * forward[0], 0);
  EXPECT_LT(down[2], 0);
}

TEST(VoxelPinholeTest, NoRayIsLongerThanOneAndTheLongestIsNearlyThat) {
  for (const int yaw : {0, 100, 512, 777, 1500})
    for (const int pitch : {-400, 0, 114, 512})
      for (const int focal : {1, 96, 320, 4096}) {
        VoxelPinhole at;
        at.yaw = yaw;
        at.pitch = pitch;
        at.focal_length = focal;
        const voxel_view view = pinhole_view(at, 640, 480, World);
        double most = 0;
        for (int y = 0; y < 480; y += 479)
          for (int x = 0; x < 640; x += 639)
            for (const double each : ray(view, x, y)) most = std::max(most, std::abs(each));
        EXPECT_LT(most, One);
        EXPECT_GT(most, One - 2048);
      }
}

TEST(VoxelPinholeTest, StandsInTheWorldThatRepeats) {
  VoxelPinhole at;
  at.position = {600.5, -1.25, 300.125};
  const vec3 origin = pinhole_view(at, 64, 48, World).origin;
  EXPECT_THAT(origin, ElementsAre(88 * 256 + 128, 254 * 256 + 192, 300 * 256 + 32));
}

TEST(VoxelPinholeTest, AShiftMovesThePixelThatLooksForward) {
  VoxelPinhole at;
  at.shift_x = 100;
  at.shift_y = -50;
  const Vector3 forward = reduced(ray(pinhole_view(at, 640, 480, World), 420, 190));
  EXPECT_NEAR(forward[0], 0, 1e-4);
  EXPECT_NEAR(forward[2], 0, 1e-4);
}

TEST(VoxelPinholeTest, ParabolasStandForSinesIfAskedFor) {
  for (const int quarter : {0, 1, 2, 3})
    for (const int part : {0, 100, 256, 400}) {
      VoxelPinhole at;
      at.yaw = 512 * quarter + part;
      at.parabolas = true;
      const voxel_view view = pinhole_view(at, 640, 480, World);
      const double u = part / 512.0, sine = u * (2 - u), cosine = (1 - u) * (1 + u);
      const std::array<std::array<double, 2>, 4> right = {
          {{cosine, -sine}, {-sine, -cosine}, {-cosine, sine}, {sine, cosine}}};
      const auto& expected = right[static_cast<std::size_t>(quarter)];
      const double unit = -view.dy[2];  // 1
      EXPECT_NEAR(view.dx[0] / unit, expected[0], 1e-4);
      EXPECT_NEAR(view.dx[1] / unit, expected[1], 1e-4);
    }
}

TEST(VoxelPinholeTest, LightsAreOfLengthOne) {
  EXPECT_THAT(voxel_light({1, 2, 4}), ElementsAre(14301, 28602, 57205));
  EXPECT_THAT(voxel_light({0, 0, 0.001}), ElementsAre(0, 0, 65536));
}

}  // namespace
}  // namespace racebeam
