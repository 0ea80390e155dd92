// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/voxel_golden.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace racebeam {

namespace {

using Vector = std::array<double, 3>;

constexpr double PositionOne = 1 << 8, DirectionOne = 1 << 16;
constexpr double FarAway = 1 << 15;  // the numbers of the tracer end there
constexpr double NoEntry = 1e-9;     // of a ray's parameter: it only touches the column
constexpr double Never = std::numeric_limits<double>::infinity();
constexpr double ShadowLift = 1.5;  // units from a hit towards the light
constexpr int Heights = 16, Materials = 16;

int wrapped(int at, int size) { return (at % size + size) % size; }

/// Where a ray leaves the column `cell` along an axis.
double leaves(double from, double towards, int cell) {
  if (towards > 0) return (cell + 1 - from) / towards;
  if (towards < 0) return (cell - from) / towards;
  return Never;
}

struct Solid {
  double bottom, top;
};

/// The first parameter from t0 on, before t1, at which a height is in the solid.
std::optional<double> enters(const Solid& solid, double from, double towards, double t0,
                             double t1) {
  const double z = from + towards * t0;
  if (z >= solid.bottom && z < solid.top) return t0;
  if (solid.bottom >= solid.top || towards == 0) return {};
  const double t = ((towards < 0 ? solid.top : solid.bottom) - from) / towards;
  if (t >= t0 && t < t1) return t;
  return {};
}

}  // namespace

VoxelGolden::Column VoxelGolden::column(int x, int y) const {
  const auto at =
      static_cast<std::size_t>(wrapped(y, k_.size_y)) * static_cast<std::size_t>(k_.size_x) +
      static_cast<std::size_t>(wrapped(x, k_.size_x));
  const std::uint32_t word = columns_[at];
  const auto field = [word](int shift, unsigned mask) {
    return static_cast<int>(word >> shift & mask);
  };
  return {field(0, 255), field(8, 255), field(16, 255), field(24, 7), field(27, 7)};
}

Vector VoxelGolden::direction(int x, int y) const {
  Vector d;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t sum = std::int64_t{view_.d00[axis]} + std::int64_t{x} * view_.dx[axis] +
                             std::int64_t{y} * view_.dy[axis];
    d[axis] = static_cast<double>(sum >> 8) / DirectionOne;
  }
  return d;
}

VoxelGolden::Hit VoxelGolden::hit(const Vector& from, const Vector& towards) const {
  double t = 0;
  if (from[2] >= k_.size_z) {
    if (towards[2] >= 0) return {};
    t = (k_.size_z - from[2]) / towards[2];
  }
  int x = static_cast<int>(std::floor(from[0] + towards[0] * t));
  int y = static_cast<int>(std::floor(from[1] + towards[1] * t));
  for (;;) {
    const double out_x = leaves(from[0], towards[0], x), out_y = leaves(from[1], towards[1], y);
    const double out = std::min({out_x, out_y, FarAway});
    const Column c = column(x, y);
    if (out - t > NoEntry) {
      const Solid solids[] = {{-Never, double(c.low)}, {double(c.middle), double(c.high)}};
      const auto lower = enters(solids[0], from[2], towards[2], t, out);
      const auto upper = enters(solids[1], from[2], towards[2], t, out);
      if (lower || upper) {
        const bool is_upper = upper && (!lower || *upper < *lower);
        const double at = is_upper ? *upper : *lower;
        return {false,
                wrapped(x, k_.size_x),
                wrapped(y, k_.size_y),
                is_upper,
                {from[0] + towards[0] * at, from[1] + towards[1] * at, from[2] + towards[2] * at}};
      }
    }
    t = std::max(t, out);
    const double z = from[2] + towards[2] * t;
    if ((z >= k_.size_z && towards[2] >= 0) || z < 0 || out == FarAway) return {};
    (out_x <= out_y ? x : y) += (out_x <= out_y ? towards[0] : towards[1]) > 0 ? 1 : -1;
    if (std::abs(x) > FarAway || std::abs(y) > FarAway) return {};
  }
}

VoxelGolden::Hit VoxelGolden::hit(int x, int y) const {
  Vector from;
  for (std::size_t axis = 0; axis < 3; ++axis) from[axis] = view_.origin[axis] / PositionOne;
  return hit(from, direction(x, y));
}

int VoxelGolden::slope(const Hit& hit) const {
  const auto height = [&](int east, int north) {
    const Column c = column(hit.x + east, hit.y + north);
    return hit.upper ? c.high : c.low;
  };
  return 2 * (height(1, 0) - height(-1, 0)) + (height(0, 1) - height(0, -1));
}

std::array<int, 3> VoxelGolden::pixel(int x, int y) const {
  const Hit found = hit(x, y);
  if (found.sky) {
    const int up = static_cast<int>(std::floor(direction(x, y)[2] * 16));
    const int below = 15 - (k_.sky == VoxelSkyGradient ? std::clamp(up, 0, 15) : 7);
    return {72 + 8 * below, 136 + 6 * below, 224 + 2 * below};
  }
  const Column c = column(found.x, found.y);
  const int bottom = found.upper ? c.middle : 0, top = found.upper ? c.high : c.low;
  const int z = std::clamp(static_cast<int>(std::floor(found.at[2])), bottom, std::max(top - 1, 0));
  const int material = found.upper ? c.high_material : c.low_material;
  const int rgb =
      palette_[static_cast<std::size_t>(material * Materials + z * Heights / k_.size_z)];
  int light = 16;
  if (k_.shading == VoxelShadingSlope) light = std::clamp(10 - slope(found), 2, 15);
  bool dark = false;
  if (k_.shadows) {
    Vector from, towards;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      towards[axis] = view_.light[axis] / DirectionOne;
      from[axis] = found.at[axis] + ShadowLift * towards[axis];
    }
    dark = !hit(from, towards).sky;
  }
  std::array<int, 3> colour;
  for (std::size_t n = 0; n < 3; ++n)
    colour[n] = ((rgb >> (16 - 8 * static_cast<int>(n)) & 255) * light >> 4) >> dark;
  return colour;
}

}  // namespace racebeam
