// What a scene of spheres is to the hardware: an entry of the sphere table, the planes, where eye,
// light and screen start, and the two scenes that are built in.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/fixed_point.h"
#include "sc/sphere/codes.h"

namespace racebeam {

/// 5 bits a channel.
using sphere_colour = std::array<int, 3>;

/// An entry of sphere_table.
struct sphere_row {
  vec3 centre{};    ///< 12.12
  int radius = 0;   ///< whole units
  int radius2 = 0;  ///< its square
  int inverse = 0;  ///< 4096 / radius, rounded down
  int reflect = 0;  ///< of 4096
  sphere_colour colour{};
  bool is_light = false;

  /// A sphere of radius 1..63; 4096 / 1 does not fit 12 bits and is 4095.
  static constexpr sphere_row of(const vec3& centre, int radius, const sphere_colour& colour,
                                 int reflect) {
    return {centre, radius, radius * radius, radius == 1 ? 4095 : 4096 / radius, reflect,
            colour, false};
  }
  /// As the CPU sends it: {light, red, green, blue}.
  constexpr int color_word() const {
    return ((is_light << 5 | colour[0]) << 5 | colour[1]) << 5 | colour[2];
  }
  static constexpr sphere_row light(const vec3& centre) {
    sphere_row row = of(centre, LightRadius, {31, 31, 31}, 0);
    row.is_light = true;
    return row;
  }
};

/// A plane: normal . p + distance = 0.
struct plane_row {
  vec3 normal{};  ///< 12.12, of length 1
  int distance = 0;
  sphere_colour colour{};
  int reflect = 0;  ///< of 4096
  int checker = 0;  ///< mask of whole units; 0: no checkerboard
  bool limited = false;
  vec3 limit{};  ///< whole units
};

/// Where the scene starts, 12.12.
struct sphere_start {
  vec3 origin{0, 0, -32 * 4096}, light{15 * 4096, 15 * 4096, -4096};
  int screen = 8 * 4096;
};

/// The board's switches and keys; keys are 0 while pressed.
struct sphere_board {
  int sw = 1 << 5;  // 512 x 480, no reflections
  int key_n = 15;
};

/// What chip and board hold of a scene file; its spheres come from the CPU.
struct sphere_tables : scene_tables {
  sphere_start start;
  std::vector<plane_row> planes;
  sphere_board board;  ///< at the reset
  int spheres = 4;     ///< how many the CPU sends; as the first scene that is built in has
};

/// The scene that is drawn if no CPU answers, 0 or 1.
inline const std::vector<sphere_row>& builtin_spheres(bool second) {
  constexpr int One = 4096;
  static const std::vector<sphere_row> scenes[2] = {
      {sphere_row::of({-9 * One, 0, 15 * One}, 5, {31, 4, 4}, 0x400),
       sphere_row::of({9 * One, 0, 15 * One}, 5, {4, 31, 4}, 0x400),
       sphere_row::of({0, -9 * One, 20 * One}, 5, {4, 4, 31}, 0x400),
       sphere_row::of({0, 8 * One, 10 * One}, 4, {6, 6, 6}, 0x800)},
      {sphere_row::of({0, 0, 15 * One}, 10, {31, 16, 4}, 0x400)}};
  return scenes[second];
}

}  // namespace racebeam
