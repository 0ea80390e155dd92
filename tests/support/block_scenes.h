// Scenes of the block renderer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>

#include "sc/block/block_world.h"

namespace racebeam {

inline block_tables quad_tables() {
  block_tables tables;
  tables.balls = {{{0, 0, 6}, 2.5f, {0.25f, 0.75f, 0.5f}},
                  {{-2, 1, 2}, 0.75f, {0.75f, 0.25f, 0.25f}},
                  {{2, -1, 3}, 0.75f, {0.25f, 0.25f, 0.75f}},
                  {{0.5f, 2, 1}, 0.75f, {0.75f, 0.75f, 0.25f}}};
  return tables;
}

/// 39 small spheres around a large one; none touches another.
inline block_tables forty_tables() {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * random() / 0x1p32;
  };
  const auto three = [&](double low, double high) {
    std::array<float, 3> v;
    for (float& each : v) each = static_cast<float>(between(low, high));
    return v;
  };
  block_tables tables;
  tables.balls.push_back({{0, 0, 6}, 2.5f, three(0.2, 0.9)});
  const auto touches = [](const block_ball& a, const block_ball& b) {
    double way2 = 0;
    for (std::size_t k = 0; k < 3; ++k)
      way2 += double(a.centre[k] - b.centre[k]) * (a.centre[k] - b.centre[k]);
    const double radii = double(a.radius) + b.radius;
    return way2 < radii * radii;
  };
  while (tables.balls.size() < 40) {
    block_ball ball;
    ball.radius = 0.75f;
    ball.centre[0] = static_cast<float>(between(-5, 5));
    ball.centre[1] = static_cast<float>(between(-4, 4));
    ball.centre[2] = static_cast<float>(between(1, 11));
    if (std::any_of(tables.balls.begin(), tables.balls.end(),
                    [&](const block_ball& other) { return touches(ball, other); }))
      continue;
    ball.colour = three(0.2, 0.9);
    tables.balls.push_back(ball);
  }
  return tables;
}

}  // namespace racebeam
