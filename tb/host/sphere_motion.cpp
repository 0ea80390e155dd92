// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_motion.h"

#include <algorithm>
#include <cmath>

#include "sc/base/fixed_point.h"

namespace racebeam {

namespace {

constexpr double Turn = 2 * 3.14159265358979323846 / 128;  // of one picture

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The faster, the smaller: pictures in which it goes by its own width.
int guard(const MovingSphere& s) {
  const double speed = std::max(std::sqrt(dot(s.velocity, s.velocity)), 1.0 / 64);
  return static_cast<int>(std::clamp(std::ceil(2 * s.radius / speed), 1.0, 63.0));
}

}  // namespace

void SphereMotion::move() {
  for (MovingSphere& s : spheres_)
    for (std::size_t n = 0; n < 3; ++n) {
      s.centre[n] += s.velocity[n];
      const double inside = std::clamp(s.centre[n], box_.low[n], box_.high[n]);
      if (inside == s.centre[n]) continue;
      s.centre[n] = inside;
      s.velocity[n] = -s.velocity[n];
    }
}

bool SphereMotion::may_collide(const MovingSphere& a, const MovingSphere& b) const {
  return capture_guard_ != GuardCounter || (a.counter == 0 && b.counter == 0);
}

void SphereMotion::collide() {
  std::vector<bool> set(spheres_.size());
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    for (std::size_t j = i + 1; j < spheres_.size(); ++j) {
      MovingSphere &a = spheres_[i], &b = spheres_[j];
      if (!may_collide(a, b)) continue;
      Vector3 n = minus(b.centre, a.centre);
      const double distance = std::sqrt(dot(n, n));
      if (distance >= a.radius + b.radius || distance == 0) continue;
      for (double& each : n) each /= distance;
      const double s = dot(minus(a.velocity, b.velocity), n);
      if (capture_guard_ == GuardApproach && s <= 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        a.velocity[k] -= s * n[k];
        b.velocity[k] += s * n[k];
      }
      ++collisions_;
      a.counter = guard(a);
      b.counter = guard(b);
      set[i] = set[j] = true;
    }
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    if (!set[i] && spheres_[i].counter) --spheres_[i].counter;
}

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
  move();
  collide();
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
