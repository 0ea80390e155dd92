// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_motion.h"

#include <cmath>

#include "sc/base/fixed_point.h"

namespace racebeam {

namespace {

constexpr double Turn = 2 * 3.14159265358979323846 / 128;  // of one picture

}  // namespace

void SphereMotion::rotate(int rotz) {
  // Bit 5: z counter clockwise, 4: z clockwise; 3, 2: x; 1, 0: y.
  static constexpr std::size_t axes[3][2] = {{0, 1}, {1, 2}, {2, 0}};
  for (int bit = 5; bit >= 0; --bit) {
    if (!bit_of(rotz, bit)) continue;
    const std::size_t u = axes[(5 - bit) / 2][0], v = axes[(5 - bit) / 2][1];
    const double cosine = std::cos(Turn), sine = bit % 2 ? std::sin(Turn) : -std::sin(Turn);
    for (MovingSphere& s : spheres_) {
      const double a = s.centre[u], b = s.centre[v];
      s.centre[u] = a * cosine - b * sine;
      s.centre[v] = a * sine + b * cosine;
    }
  }
}

void SphereMotion::picture(int rotz) {
  move(spheres_, box_);
  collisions_ += collide(spheres_, [&](const auto& a, const auto& b, double approach) {
    if (capture_guard_ == GuardCounter) return a.counter == 0 && b.counter == 0;
    return capture_guard_ == GuardOff || approach > 0;
  });
  rotate(rotz);
}

std::vector<sphere_row> SphereMotion::table() const {
  std::vector<sphere_row> rows;
  for (const MovingSphere& s : spheres_)
    rows.push_back(sphere_row::of(table_position(s.centre), s.radius, s.colour, s.reflect));
  return rows;
}

vec3 table_position(const Vector3& position) {
  vec3 fixed{};
  for (std::size_t n = 0; n < 3; ++n)
    fixed[n] = wrap_signed(static_cast<int>(std::lround(position[n] * 4096)), SphereBits);
  return fixed;
}

}  // namespace racebeam
