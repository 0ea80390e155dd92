// Scene four of the sphere tracer, as tables.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/sphere/sphere_scene.h"

namespace racebeam {

inline std::vector<sphere_row> four_spheres() {
  constexpr int One = 4096;
  return {sphere_row::of({-9 * One, 0, 15 * One}, 5, {31, 4, 4}, 0x400),
          sphere_row::of({9 * One, 0, 15 * One}, 5, {4, 31, 4}, 0x400),
          sphere_row::of({0, -9 * One, 20 * One}, 5, {4, 4, 31}, 0x400),
          sphere_row::of({0, 8 * One, 10 * One}, 4, {6, 6, 6}, 0x800)};
}

inline sphere_tables four_tables() {
  constexpr int One = 4096;
  const auto plane = [](const vec3& normal, int distance, const sphere_colour& colour,
                        int checker) {
    return plane_row{normal, distance * One, colour, 0x800, checker, false, {}};
  };
  sphere_tables tables;
  tables.planes = {plane({0, 0, -One}, 40, {0, 0, 0}, 0), plane({0, -One, 0}, 22, {29, 29, 29}, 1),
                   plane({-One, 0, 0}, 26, {0, 0, 0}, 0), plane({One, 0, 0}, 26, {0, 0, 0}, 0)};
  return tables;
}

}  // namespace racebeam
