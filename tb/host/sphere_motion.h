// sphere_motion: the CPU beside the sphere tracer: moves, bounces and turns the spheres, once a
// picture, in double precision.
//
// In this order: move, collide, count down, rotate. World units, per picture. Source: report
// "Software Overview".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"
#include "tb/host/ball_motion.h"

namespace racebeam {

struct MovingSphere {
  Vector3 centre{}, velocity{};
  int radius = 1;  ///< whole, 1..63
  sphere_colour colour{};
  int reflect = 0;  ///< of 4096
  int counter = 0;  ///< pictures until it collides again
};

class SphereMotion {
 public:
  SphereMotion(std::vector<MovingSphere> spheres, const MotionBox& box,
               int capture_guard = GuardCounter)
      : spheres_(std::move(spheres)), box_(box), capture_guard_(capture_guard) {}

  /// A picture on; `rotz`: the turns that the tracer asks for.
  void picture(int rotz = 0);
  const std::vector<MovingSphere>& spheres() const { return spheres_; }
  /// Since the start.
  int collisions() const { return collisions_; }
  /// As the tracer's table has them.
  std::vector<sphere_row> table() const;

 private:
  void rotate(int rotz);

  std::vector<MovingSphere> spheres_;
  MotionBox box_;
  int capture_guard_;
  int collisions_ = 0;
};

/// A centre of the table: the nearest 12.12, in 24 bits.
vec3 table_position(const Vector3& position);

}  // namespace racebeam
