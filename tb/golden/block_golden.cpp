// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/block_golden.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

using Vector = std::array<double, 3>;

constexpr double FarAway = 2047, FullChannel = 255;

Vector number(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector along(const Vector& from, const Vector& way, double t) {
  return {from[0] + way[0] * t, from[1] + way[1] * t, from[2] + way[2] * t};
}
Vector unit(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace

BlockGolden::Ray BlockGolden::primary(int x, int y) const {
  const double across = tables_.screen[0] * (double(x) / knobs_.columns() - 0.5);
  const double up = tables_.screen[1] * (0.5 - double(y) / knobs_.rows());
  const Vector eye = number(tables_.eye);
  return {eye, unit(along({across, up, 0}, eye, -1)), -1};
}

BlockGolden::Hit BlockGolden::nearest(const Ray& ray) const {
  Hit hit{-1, FarAway};
  for (std::size_t n = 0; n < tables_.balls.size(); ++n) {
    if (static_cast<int>(n) == ray.own) continue;
    const block_ball& ball = tables_.balls[n];
    const Vector v = along(ray.from, number(ball.centre), -1);
    const double b = dot(v, ray.way), d = b * b - dot(v, v) + double(ball.radius) * ball.radius;
    if (d <= 0) continue;
    const double t = -b - std::sqrt(d);
    if (t > 0 && t < hit.t) hit = {static_cast<int>(n), t};
  }
  return hit;
}

Vector BlockGolden::shade(Ray& ray, const Hit& hit) const {
  const block_ball& ball = tables_.balls[static_cast<std::size_t>(hit.sphere)];
  const Vector point = along(ray.from, ray.way, hit.t);
  const Vector normal = unit(along(point, number(ball.centre), -1));
  const Vector to_light = along(number(tables_.light), point, -1), lit = unit(to_light);
  const double diffuse = std::max(dot(normal, lit), 0.0);
  const double shine = std::pow(std::max(dot(ray.way, along(lit, normal, -2 * diffuse)), 0.0),
                                1 << knobs_.specular_squarings);
  ray = {point, along(ray.way, normal, -2 * dot(ray.way, normal)), hit.sphere};
  if (knobs_.shadow_rays &&
      nearest({point, lit, hit.sphere}).t < std::sqrt(dot(to_light, to_light)))
    return {};
  return along({shine, shine, shine}, number(ball.colour), diffuse);
}

std::array<double, 3> BlockGolden::pixel(int x, int y) const {
  Ray ray = primary(x, y);
  Vector colour{};
  for (int pass = 0; pass < knobs_.max_passes; ++pass) {
    const Hit hit = nearest(ray);
    if (hit.sphere < 0) {
      if (pass > 0) break;
      const int back = knobs_.background;
      return {double(back >> 16), double(back >> 8 & 255), double(back & 255)};
    }
    colour = along(colour, shade(ray, hit), 1);
  }
  for (double& each : colour) each = std::min(each * 256, FullChannel);
  return colour;
}

int BlockGolden::first_hit(int x, int y) const { return nearest(primary(x, y)).sphere; }

}  // namespace racebeam
