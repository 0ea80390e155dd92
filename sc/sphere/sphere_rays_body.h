// Templates of sphere_rays.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/sphere/sphere_rays.h"

namespace racebeam {

template <class Log>
bool sphere_rays::meet_spheres(ray& r, Log& log) {
  const int last = spheres_.last_q;
  for (int object = 0;; object = (object + 1) & low_bits(SphereIndexBits)) {
    const sphere_row& s = spheres_.row(object);
    const vec3 c = difference(s.centre, r.org);
    const std::int64_t c2 = dot(c, c), r2 = wrap48(std::int64_t{s.radius2} << SphereBits);
    const bool inside = c2 < r2;
    ++n_.sphere_tests;
    stay(log, SphereCentre, 1, object, "");
    stay(log, SphereAlong, 1, object, inside ? "inside" : "");
    if (inside && r.nref == 0) {
      ++n_.black_inside;
      return true;
    }
    const std::int64_t along = dot(r.dir, c);
    const int tca = floor24(along);
    stay(log, SphereFront, 1, object, along < 0 ? "behind" : "");
    if (along >= 0) {
      const std::int64_t d = wrap48(std::int64_t{tca} * tca - c2 + r2);
      stay(log, SphereChord, 1, object, d < 0 ? "missed" : "");
      if (d >= 0) {
        ++n_.roots;
        ++n_.hits;
        const int root = root_of(static_cast<int>(d >> SphereFraction & low_bits(SphereBits)));
        const int t = (inside ? tca + root : tca - root) & low_bits(SphereBits);
        const bool nearer = !r.hit || t < r.t;
        if (nearer) {
          r.hit = true;
          r.t = t;
          r.index = object;
          r.is_light = s.is_light;
          r.point = masked(point_of(r.org, r.dir, t), mask_);
          r.base = s.colour;
          r.reflect = s.reflect;
        }
        stay(log, SphereWait, 1, object, "");
        stay(log, SphereHit, k_.root_clocks() - 1, object, nearer ? "nearest" : "farther");
      }
    }
    if (object == last) return false;
  }
}

template <class Log>
void sphere_rays::meet_planes(ray& r, Log& log) {
  for (int object = 0; object < static_cast<int>(planes_.size()); ++object) {
    const plane_row& p = planes_[object];
    const std::int64_t towards = dot(p.normal, r.dir);
    ++n_.plane_tests;
    stay(log, SpherePlane, 1, object, towards >= 0 ? "turned away" : "");
    if (towards >= 0) continue;
    const int vo = wrap24(-floor24(dot(p.normal, r.org)) - p.distance);
    const int t = quotient_of(std::int64_t{vo} * 4096, floor24(towards));
    ++n_.divisions;
    stay(log, SpherePlaneD, 1, object, "");
    bool nearer = t > NearestPlane && (!r.hit || t < r.t);
    if (nearer) {
      const vec3 point = point_of(r.org, r.dir, t);
      for (int n = 0; n < 3 && p.limited; ++n)
        nearer &= (point[n] < 0 ? -point[n] : point[n]) >> SphereFraction < p.limit[n];
      if (nearer) {
        r.hit = r.hit_plane = true;
        r.t = t;
        r.index = object;
        r.point = masked(point, mask_);
        r.normal = p.normal;
        r.base = p.colour;
        r.reflect = p.reflect;
        r.dark = ((point[0] ^ point[2]) >> SphereFraction & p.checker) != 0;
      }
    }
    stay(log, SpherePlaneT, k_.divide_clocks + 1, object, nearer ? "nearest" : "");
  }
}

template <class Log>
bool sphere_rays::behind_plane(const ray& r, const vec3& lray, int distance, Log& log) {
  for (int object = 0; object < static_cast<int>(planes_.size()); ++object) {
    const plane_row& p = planes_[object];
    const std::int64_t towards = dot(p.normal, lray);
    ++n_.plane_tests;
    stay(log, SpherePlane, 1, object, towards >= 0 ? "turned away" : "");
    if (towards >= 0) continue;
    const int vo = wrap24(-floor24(dot(p.normal, r.point)) - p.distance);
    const int t = quotient_of(std::int64_t{vo} * 4096, floor24(towards));
    ++n_.divisions;
    stay(log, SpherePlaneD, 1, object, "");
    bool meets = t > NearestPlane && t <= distance;
    const vec3 point = point_of(r.point, lray, t);
    for (int n = 0; n < 3 && p.limited; ++n)
      meets &= (point[n] < 0 ? -point[n] : point[n]) >> SphereFraction < p.limit[n];
    stay(log, SpherePlaneT, k_.divide_clocks + 1, object, meets ? "in shadow" : "");
    if (meets) return true;
  }
  return false;
}

template <class Log>
bool sphere_rays::in_shadow(const ray& r, const vec3& lray, int distance, Log& log) {
  const int last = spheres_.last_q;
  for (int object = 0; k_.shadow_rays && object != last; ++object) {
    const sphere_row& s = spheres_.row(object);
    const vec3 c = difference(s.centre, r.point);
    const std::int64_t c2 = dot(c, c), r2 = wrap48(std::int64_t{s.radius2} << SphereBits);
    const std::int64_t along = dot(lray, c);
    ++n_.sphere_tests;
    stay(log, SphereShadowCentre, 1, object, "");
    stay(log, SphereShadowAlong, 1, object, "");
    const bool own = !r.hit_plane && object == r.index;
    if (along < 0) {
      stay(log, SphereShadowFront, 1, object, "behind");
    } else if (own || c2 < r2) {
      stay(log, SphereShadowFront, 1, object, "in shadow");
      return true;
    } else if (floor24(along) > distance) {
      stay(log, SphereShadowFront, 1, object, "beyond the light");
    } else {
      const int tca = floor24(along);
      stay(log, SphereShadowFront, 1, object, "");
      const bool meets = wrap48(std::int64_t{tca} * tca - c2 + r2) >= 0;
      stay(log, SphereShadowChord, 1, object, meets ? "in shadow" : "missed");
      if (meets) return true;
    }
  }
  stay(log, SphereShadowCentre, 1, -1, "no more spheres");
  return k_.plane_shadows && in_.planes_q && behind_plane(r, lray, distance, log);
}

template <class Log>
void sphere_rays::light(ray& r, Log& log) {
  if (!r.hit_plane) stay(log, SphereLight, 1, r.index, r.is_light ? "the light" : "");
  if (r.is_light) {
    shade(ShadeLight, r, 0, sub_);
    return;
  }
  vec3 lray = towards_light(in_.light_q, r.point, mask_);
  ++n_.shadow_rays;
  const int distance = normalise(lray) << 4;
  stay(log, SphereLray, 1, r.index, "");
  stay(log, SphereLroot, k_.root_clocks(), r.index, "");
  stay(log, SphereLdivide, k_.divide_clocks + 1, r.index, "");
  stay(log, SphereNormal, 1, r.index, "");
  if (!r.hit_plane) {
    const sphere_row& s = spheres_.row(r.index);
    r.normal = scaled(difference(r.point, s.centre), s.inverse);
  }
  stay(log, SphereLambert, 1, r.index, "");
  if (r.hit_plane) {
    shade(ShadePlain, r, 0, sub_);
  } else {
    const std::int64_t cosine = dot(r.normal, lray);
    stay(log, SphereShade, 1, r.index, cosine < 0 ? "facing away" : "");
    if (cosine < 0) {
      shade(ShadeHalf, r, 0, sub_);
      return;
    }
    const int fraction = static_cast<int>(std::min<std::int64_t>(cosine >> SphereFraction, 0xfff));
    shade(ShadeLit, r, fraction, sub_);
  }
  if (in_shadow(r, lray, distance, log)) {
    ++n_.shadowed;
    shade(ShadeHalf, r, 0, sub_);
  }
}

template <class Log, class Offer>
void sphere_rays::sub_ray(int x, int y, int sub, Log& log, Offer& offer) {
  ray r{};
  r.dir = masked(
      sphere_raygen_core::comb({x, y, sub, in_.origin_q, in_.screen_q, in_.narrow_q}, k_), mask_);
  r.org = in_.origin_q;
  for (;;) {
    ++(r.nref ? n_.reflected_rays : n_.primary_rays);
    normalise(r.dir);
    stay(log, SphereRay, 1, -1, "");
    stay(log, SphereRoot, k_.root_clocks(), -1, "");
    stay(log, SphereDivide, k_.divide_clocks + 1, -1, "");
    r.hit = r.hit_plane = r.is_light = r.dark = false;
    if (meet_spheres(r, log)) return;
    if (!r.hit && in_.planes_q) meet_planes(r, log);
    if (!r.hit) return;
    light(r, log);
    const int weight = shader_.weight(r.reflect);
    shade(ShadeAdd, r, 0, sub);
    ++n_.passes;
    const bool stop = r.nref == in_.max_reflections_q || weight < k_.min_weight || r.is_light;
    stay(log, SphereAdd, 1, r.index, stop ? "stops" : "goes on");
    if (stop) return;
    int wait = 0;
    if (k_.write_each_pass) wait = offer(clocks_, shader_.word(sub, in_.alias_q, k_));
    const int n2 = wrap24(static_cast<int>(dot(r.dir, r.normal) >> (SphereFraction - 1)));
    r.dir = masked(difference(r.dir, scaled(r.normal, n2)), mask_);
    r.org = r.point;
    ++r.nref;
    stay(log, SphereReflect, 2 + wait, r.index, "");
  }
}

template <class Log, class Offer>
int sphere_rays::pixel(int x, int y, Log&& log, Offer&& offer) {
  clocks_ = 0;
  const int last = last_sub(in_.alias_q);
  for (sub_ = 0; sub_ <= last; ++sub_) {
    sub_ray(x, y, sub_, log, offer);
    int wait = 0;
    if (k_.write_each_pass || sub_ == last)
      wait = offer(clocks_, shader_.word(sub_, in_.alias_q, k_));
    shader_.clock({true, ShadeStore, {}, false, 0, 0, false, sub_, in_.alias_q});
    stay(log, SphereNext, 1 + wait, -1, sub_ == last ? "the pixel" : "the sub-ray");
  }
  return clocks_;
}

inline void sphere_rays::take(sphere_counters& to) {
  static constexpr std::uint64_t sphere_counters::*counted[] = {
      &sphere_counters::primary_rays, &sphere_counters::reflected_rays,
      &sphere_counters::shadow_rays,  &sphere_counters::sphere_tests,
      &sphere_counters::plane_tests,  &sphere_counters::roots,
      &sphere_counters::divisions,    &sphere_counters::hits,
      &sphere_counters::passes,       &sphere_counters::shadowed,
      &sphere_counters::black_inside, &sphere_counters::overflows};
  for (const auto member : counted) to.*member += n_.*member;
  for (int n = 0; n < SphereStates; ++n) {
    to.state_clocks[n] += states_[n];
    to.clocks += states_[n];
    states_[n] = 0;
  }
  n_ = {};
}

}  // namespace racebeam
