// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/sphere_golden.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sc/sphere/first_hit.h"

namespace racebeam {

namespace {

constexpr double One = 4096;
constexpr double FullWeight = 4095 / One, FullChannel = 1023;
constexpr double NearPlane = 0.25;

using Vector = std::array<double, 3>;

Vector number(const vec3& v) { return {v[0] / One, v[1] / One, v[2] / One}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector along(const Vector& from, const Vector& way, double t) {
  return {from[0] + way[0] * t, from[1] + way[1] * t, from[2] + way[2] * t};
}
double normalise(Vector& v) {
  const double length = std::sqrt(dot(v, v));
  for (double& each : v) each /= length;
  return length;
}
Vector channels(const sphere_colour& c) { return {c[0] * 32.0, c[1] * 32.0, c[2] * 32.0}; }
Vector times(const Vector& v, double s) { return {v[0] * s, v[1] * s, v[2] * s}; }

}  // namespace

SphereGolden::SphereGolden(SphereGoldenScene scene)
    : scene_(std::move(scene)),
      eye_(number(scene_.tables.start.origin)),
      light_(number(scene_.tables.start.light)),
      screen_(scene_.tables.start.screen / One) {
  for (const sphere_row& s : scene_.spheres)
    balls_.push_back(
        {number(s.centre), double(s.radius), s.reflect / One, channels(s.colour), s.is_light});
  balls_.push_back({light_, LightRadius, 0, {}, true});
}

bool SphereGolden::meet_spheres(const Vector& origin, const Vector& direction, int own,
                                bool primary, Hit& hit) const {
  for (std::size_t n = 0; n < balls_.size(); ++n) {
    if (static_cast<int>(n) == own) continue;
    const Ball& ball = balls_[n];
    const Vector c = along(ball.centre, origin, -1);
    const double c2 = dot(c, c), r2 = ball.radius * ball.radius;
    const bool inside = c2 < r2;
    if (inside && primary) return true;
    const double tca = dot(direction, c), d = tca * tca - c2 + r2;
    if (tca < 0 || d < 0) continue;
    const double t = inside ? tca + std::sqrt(d) : tca - std::sqrt(d);
    if (hit.any && t >= hit.t) continue;
    hit.any = true;
    hit.t = t;
    hit.index = n;
    hit.point = along(origin, direction, t);
    hit.normal = times(along(hit.point, ball.centre, -1), 1 / ball.radius);
    hit.colour = ball.colour;
    hit.reflect = ball.reflect;
    hit.is_light = ball.is_light;
  }
  return false;
}

void SphereGolden::meet_planes(const Vector& origin, const Vector& direction, Hit& hit) const {
  for (std::size_t index = 0; index < scene_.tables.planes.size(); ++index) {
    const plane_row& plane = scene_.tables.planes[index];
    const Vector normal = number(plane.normal);
    const double towards = dot(normal, direction);
    if (towards >= 0) continue;
    const double t = -(dot(normal, origin) + plane.distance / One) / towards;
    if (t <= NearPlane || (hit.any && t >= hit.t)) continue;
    const Vector p = along(origin, direction, t);
    bool within = true;
    for (std::size_t n = 0; n < 3 && plane.limited; ++n)
      within &= std::floor(std::fabs(p[n])) < plane.limit[n];
    if (!within) continue;
    const auto square = [&](double at) { return static_cast<int>(std::floor(at)) & plane.checker; };
    hit.any = hit.plane = true;
    hit.index = index;
    hit.t = t;
    hit.point = p;
    hit.normal = normal;
    hit.colour = times(channels(plane.colour), square(p[0]) != square(p[2]) ? 0.25 : 1);
    hit.reflect = plane.reflect / One;
  }
}

bool SphereGolden::in_shadow(const Hit& hit, const Vector& to_light, double distance) const {
  if (!scene_.shadows) return false;
  for (std::size_t n = 0; n + 1 < balls_.size(); ++n) {
    if (!hit.plane && n == hit.index) continue;
    const Vector c = along(balls_[n].centre, hit.point, -1);
    const double c2 = dot(c, c), r2 = balls_[n].radius * balls_[n].radius, tca = dot(to_light, c);
    if (tca < 0) continue;
    if (c2 < r2 || (tca <= distance && tca * tca - c2 + r2 >= 0)) return true;
  }
  if (!scene_.plane_shadows || !scene_.planes) return false;
  Hit plane;
  meet_planes(hit.point, to_light, plane);
  return plane.any && plane.t <= distance;
}

SphereGolden::Vector SphereGolden::shade(const Hit& hit) const {
  if (hit.is_light) return {FullChannel, FullChannel, FullChannel};
  Vector to_light = along(light_, hit.point, -1);
  const double distance = normalise(to_light);
  const double cosine = dot(hit.normal, to_light);
  const bool lit = (hit.plane || cosine >= 0) && !in_shadow(hit, to_light, distance);
  if (!lit) return times(hit.colour, 0.5);
  return times(hit.colour, hit.plane ? 1 : std::min(cosine, 1.0) + 0.5);
}

void SphereGolden::aim(Vector& way) const {
  normalise(way);
  if (scene_.direction_bits == 0) return;
  for (double& each : way)
    each = std::ldexp(std::trunc(std::ldexp(each, scene_.direction_bits)), -scene_.direction_bits);
}

SphereGolden::Vector SphereGolden::direction(double x, double y) const {
  Vector way = {(x - scene_.columns / 2.0 - eye_[0]) / 32, (y - scene_.rows / 2.0 - eye_[1]) / 32,
                screen_ - eye_[2] / 32};
  aim(way);
  return way;
}

int SphereGolden::first_hit(int x, int y) const {
  const Vector way = direction(x, y);
  Hit hit;
  if (meet_spheres(eye_, way, -1, true, hit)) return EyeInside;
  if (!hit.any && scene_.planes) meet_planes(eye_, way, hit);
  if (!hit.any) return MeetsNothing;
  return static_cast<int>(hit.index) + (hit.plane ? FirstPlane : 0);
}

SphereGolden::Vector SphereGolden::ray(double x, double y) const {
  Vector sum{}, origin = eye_, direction = this->direction(x, y);
  double weight = FullWeight;
  int own = -1;
  for (int reflections = 0;; ++reflections) {
    Hit hit;
    if (meet_spheres(origin, direction, own, reflections == 0, hit)) return sum;
    if (!hit.any && scene_.planes) meet_planes(origin, direction, hit);
    if (!hit.any) return sum;
    const Vector colour = shade(hit);
    for (std::size_t n = 0; n < 3; ++n) sum[n] = std::min(sum[n] + colour[n] * weight, FullChannel);
    weight *= hit.reflect;
    if (reflections == scene_.reflections || weight < scene_.min_weight / One || hit.is_light)
      return sum;
    direction = along(direction, hit.normal, -2 * dot(direction, hit.normal));
    aim(direction);
    origin = hit.point;
    own = hit.plane ? -1 : static_cast<int>(hit.index);
  }
}

std::array<int, 3> SphereGolden::pixel(int x, int y) const {
  static constexpr double offsets[9][2] = {{0, 0},   {-.5, -.5}, {-.5, .5}, {.5, -.5}, {.5, .5},
                                           {-.5, 0}, {0, .5},    {0, -.5},  {.5, 0}};
  Vector all{};
  for (int n = 0; n < scene_.sub_rays; ++n) {
    const double share = scene_.sub_rays == 1   ? 1
                         : scene_.sub_rays == 5 ? (n == 0 ? 0.5 : 0.125)
                         : n == 0               ? 0.25
                         : n < 5                ? 0.0625
                                                : 0.125;
    all = along(all, ray(x + offsets[n][0], y + offsets[n][1]), share);
  }
  std::array<int, 3> levels{};
  const double level = 1 << (ChannelBits - scene_.colour_bits);
  for (std::size_t n = 0; n < 3; ++n) levels[n] = static_cast<int>(all[n] / level);
  return levels;
}

}  // namespace racebeam
