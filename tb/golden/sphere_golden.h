// sphere_golden: the picture that the sphere tracer means, in double precision.
//
// The same rules with exact roots and quotients; it shares no code with sc/, only the tables. A ray
// does not meet the sphere that it starts from.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sc/sphere/sphere_scene.h"

namespace racebeam {

/// What the tracer draws, and how.
struct SphereGoldenScene {
  std::vector<sphere_row> spheres;
  sphere_tables tables;
  int columns = 512, rows = 480;
  int reflections = 0;
  int sub_rays = 1;  ///< 1, 5 (4x) or 9 (8x)
  bool planes = false;
  int min_weight = 40;  ///< of 4096
  int colour_bits = 5;  ///< of a channel
  bool shadows = true;
  bool plane_shadows = false;
  /// Directions of rays are cut, towards zero, to so many fraction bits, as the tracer's divider
  /// does it; 0: they are not.
  int direction_bits = 0;
};

class SphereGolden {
 public:
  explicit SphereGolden(SphereGoldenScene scene);

  /// Levels of red, green, blue, of colour_bits each.
  std::array<int, 3> pixel(int x, int y) const;
  /// Channels 0 to 1023 of a ray through a point of the screen, in pixels; not rounded.
  std::array<double, 3> ray(double x, double y) const;
  /// What the ray through the middle of a pixel meets first: see sphere_first_hit.
  int first_hit(int x, int y) const;

 private:
  using Vector = std::array<double, 3>;
  struct Ball {
    Vector centre;
    double radius, reflect;
    Vector colour;
    bool is_light;
  };
  struct Hit {
    bool any = false, plane = false;
    double t = 0;
    std::size_t index = 0;
    Vector point{}, normal{}, colour{};
    double reflect = 0;
    bool is_light = false;
  };

  /// Makes the length 1, and cuts.
  void aim(Vector& way) const;
  /// From the eye to a point of the screen, of length 1.
  Vector direction(double x, double y) const;
  bool meet_spheres(const Vector& origin, const Vector& direction, int own, bool primary,
                    Hit& hit) const;
  void meet_planes(const Vector& origin, const Vector& direction, Hit& hit) const;
  Vector shade(const Hit& hit) const;
  bool in_shadow(const Hit& hit, const Vector& to_light, double distance) const;

  const SphereGoldenScene scene_;
  std::vector<Ball> balls_;  // the light last
  Vector eye_{}, light_{};
  double screen_;
};

}  // namespace racebeam
