// Behaviour of sphere_raygen (sphere_raygen.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/sphere/knobs.h"
#include "sc/sphere/numbers.h"

namespace racebeam {

struct sphere_raygen_core {
  struct inputs {
    int x, y, sub;
    vec3 origin;
    int screen;
    bool narrow;
  };
  static vec3 comb(const inputs& in, const sphere_knobs& k) {
    static constexpr int offsets[SubRays][2] = {{0, 0},  {-1, -1}, {-1, 1}, {1, -1}, {1, 1},
                                                {-1, 0}, {0, 1},   {0, -1}, {1, 0}};
    const int* offset = offsets[in.sub < SubRays ? in.sub : 0];
    const int sx = in.x * 4096 + offset[0] * 2048, sy = in.y * 4096 + offset[1] * 2048;
    return wrap24((sx >> 5) - k.columns(in.narrow) * 64 - (in.origin[0] >> 5),
                  (sy >> 5) - k.rows(in.narrow) * 64 - (in.origin[1] >> 5),
                  in.screen - (in.origin[2] >> 5));
  }
};

}  // namespace racebeam
