// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_world.h"

#include <cmath>

#include "sc/block/numbers.h"

namespace racebeam {

namespace {

constexpr double ConeSteps = 8.5;

int fraction(double value) { return static_cast<int>(std::lround(value * (1 << BlockFraction))); }
int step(float side, int pixels) { return fraction(double{side} / pixels); }

}  // namespace

block_world converted(const block_tables& tables, const block_knobs& k) {
  const int kept = -(1 << (BlockFraction - k.fraction_bits));
  const auto number = [&](float value) { return f2i(value) & kept; };
  const auto vector = [&](const std::array<float, 3>& v) {
    return vec3{number(v[0]), number(v[1]), number(v[2])};
  };
  block_world world;
  world.eye = vector(tables.eye);
  world.light = vector(tables.light);
  world.start = block_difference({-number(tables.screen[0]) >> 1, number(tables.screen[1]) >> 1, 0},
                                 world.eye);
  world.ax = step(tables.screen[0], k.columns());
  world.ay = step(tables.screen[1], k.rows());
  const double angle = std::atan2(ConeSteps * std::hypot(world.ax, world.ay),
                                  std::abs(static_cast<double>(world.eye[2])));
  world.cone_sine = fraction(std::sin(angle));
  world.cone_cosine2 = fraction(std::cos(angle) * std::cos(angle));
  for (const block_ball& ball : tables.balls) {
    block_row row;
    row.centre = vector(ball.centre);
    row.colour = vector(ball.colour);
    row.radius = number(ball.radius);
    row.radius2 = imul(row.radius, row.radius);
    row.pose = block_difference(world.eye, row.centre);
    row.rv = block_difference(row.radius2, inorm2(row.pose));
    world.rows.push_back(row);
  }
  return world;
}

}  // namespace racebeam
