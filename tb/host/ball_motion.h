// How a host moves spheres in a box, once a picture, in double precision: they go on, bounce off
// the walls and off each other. For any struct with a centre, a velocity, a radius and a counter.
//
// Source: report "Software Overview"; article "Command and Control".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace racebeam {

using Vector3 = std::array<double, 3>;

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// What the centres stay in.
struct MotionBox {
  Vector3 low{-15, -15, 5}, high{15, 15, 35};
};

/// A picture on.
template <class Ball>
void move(std::vector<Ball>& balls, const MotionBox& box) {
  for (Ball& s : balls)
    for (std::size_t n = 0; n < 3; ++n) {
      s.centre[n] += s.velocity[n];
      const double inside = std::clamp(s.centre[n], box.low[n], box.high[n]);
      if (inside == s.centre[n]) continue;
      s.centre[n] = inside;
      s.velocity[n] = -s.velocity[n];
    }
}

/// Pictures in which it goes by its own width: until it may collide again.
template <class Ball>
int guard(const Ball& s) {
  const double speed = std::max(std::sqrt(dot(s.velocity, s.velocity)), 1.0 / 64);
  return static_cast<int>(std::clamp(std::ceil(2 * s.radius / speed), 1.0, 63.0));
}

/// Those that touch change the speeds along the line between them, if may_collide(a, b, speed at
/// which they come nearer) says so. Counts down; how many did.
template <class Ball, class MayCollide>
int collide(std::vector<Ball>& balls, MayCollide&& may_collide) {
  int collisions = 0;
  std::vector<bool> set(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      Ball &a = balls[i], &b = balls[j];
      Vector3 n, speed;
      for (std::size_t k = 0; k < 3; ++k) {
        n[k] = b.centre[k] - a.centre[k];
        speed[k] = a.velocity[k] - b.velocity[k];
      }
      const double distance = std::sqrt(dot(n, n));
      if (distance >= a.radius + b.radius || distance == 0) continue;
      for (double& each : n) each /= distance;
      const double s = dot(speed, n);
      if (!may_collide(a, b, s)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        a.velocity[k] -= s * n[k];
        b.velocity[k] += s * n[k];
      }
      ++collisions;
      a.counter = guard(a);
      b.counter = guard(b);
      set[i] = set[j] = true;
    }
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (!set[i] && balls[i].counter) --balls[i].counter;
  return collisions;
}

}  // namespace racebeam
