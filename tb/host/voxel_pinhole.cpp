// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_pinhole.h"

#include <algorithm>
#include <cmath>

#include "sc/voxel/numbers.h"
#include "sc/voxel/voxel_levels.h"

namespace racebeam {

namespace {

constexpr double Pi = 3.14159265358979323846;
constexpr double Quarter = 512;  // of a turn
constexpr int One = 1 << 24;     // of camera vectors
// Steps are rounded: up to half a unit in each of 640 + 480, and one in the start.
constexpr int Rounding = 1024;

/// Of an angle, some quarters of a turn later.
double sine(double angle, int quarters, bool parabola) {
  const double turned = angle / Quarter + quarters;
  if (!parabola) return std::sin(turned * Pi / 2);
  const double whole = std::floor(turned), u = turned - whole;
  const int quarter = static_cast<int>(whole) & 3;
  const double size = quarter & 1 ? (1 - u) * (1 + u) : u * (2 - u);
  return quarter & 2 ? -size : size;
}

Vector3 sum(const Vector3& a, double s, const Vector3& b, double t, const Vector3& c) {
  Vector3 all;
  for (std::size_t k = 0; k < 3; ++k) all[k] = a[k] + s * b[k] + t * c[k];
  return all;
}

int rounded(double number) { return static_cast<int>(std::lround(number)); }

vec3 scaled(const Vector3& v, double by) {
  return {rounded(v[0] * by), rounded(v[1] * by), rounded(v[2] * by)};
}

double largest(const Vector3& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

int position(double coordinate) { return rounded(coordinate * (1 << VoxelPositionFraction)); }

int within(double coordinate, int side) {
  return voxel_wrapped(position(std::fmod(coordinate, side)), side << VoxelPositionFraction);
}

}  // namespace

voxel_view pinhole_view(const VoxelPinhole& pinhole, int width, int height, const vec3& size) {
  const double sin_yaw = sine(pinhole.yaw, 0, pinhole.parabolas);
  const double cos_yaw = sine(pinhole.yaw, 1, pinhole.parabolas);
  const double sin_pitch = sine(pinhole.pitch, 0, pinhole.parabolas);
  const double cos_pitch = sine(pinhole.pitch, 1, pinhole.parabolas);
  const double f = pinhole.focal_length;
  const Vector3 forward{f * sin_yaw * cos_pitch, f * cos_yaw * cos_pitch, -f * sin_pitch};
  const Vector3 right{cos_yaw, -sin_yaw, 0};
  const Vector3 down{-sin_yaw * sin_pitch, -cos_yaw * sin_pitch, -cos_pitch};
  const double left = -width / 2.0 - pinhole.shift_x, top = -height / 2.0 - pinhole.shift_y;
  double longest = 0;
  for (const int x : {0, width - 1})
    for (const int y : {0, height - 1})
      longest = std::max(longest, largest(sum(forward, left + x, right, top + y, down)));
  const double scale = (One - Rounding) / longest;
  voxel_view view;
  view.origin = {within(pinhole.position[0], size[0]), within(pinhole.position[1], size[1]),
                 position(pinhole.position[2])};
  view.d00 = scaled(sum(forward, left, right, top, down), scale);
  view.dx = scaled(right, scale);
  view.dy = scaled(down, scale);
  return view;
}

vec3 voxel_light(const Vector3& direction) {
  return scaled(direction, (1 << VoxelDirectionFraction) / std::sqrt(dot(direction, direction)));
}

}  // namespace racebeam
