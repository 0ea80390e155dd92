// What the states do, and where they lead: sphere_tracer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_tracer_core.h"

#include "sc/sphere/sphere_shader_core.h"

namespace racebeam {

namespace {

int magnitude(int value) { return value < 0 ? -value : value; }

}  // namespace

bool sphere_tracer_core::word_valid(int alias, const sphere_knobs& k) const {
  if (state_q == SphereNext) return k.write_each_pass || sub_q == last_sub(alias);
  return state_q == SphereReflect && k.write_each_pass;
}

bool sphere_tracer_core::last_of_picture(const inputs& in, const sphere_knobs& k) const {
  return sub_q == last_sub(in.alias) && x_q == k.columns(in.narrow) - 1 &&
         y_q == k.rows(in.narrow) - 1;
}

bool sphere_tracer_core::keeps_plane(const inputs& in) const {
  const int t = in.quotient[0];
  if (t <= NearestPlane) return false;
  if (shadow_q ? t > distance() : hit_q && t >= (t_q & low_bits(SphereBits))) return false;
  if (!in.plane.limited) return true;
  const vec3 p = sum_of(start(), in.vector.product);
  for (int n = 0; n < 3; ++n)
    if (magnitude(p[n]) >> SphereFraction >= in.plane.limit[n]) return false;
  return true;
}

int sphere_tracer_core::shader(const inputs& in, const sphere_knobs& k) const {
  switch (state_q) {
    case SphereHost: return ShadeStart;
    case SphereLight: return is_light_q ? ShadeLight : ShadeHold;
    case SphereLambert: return hit_plane_q ? ShadePlain : ShadeHold;
    case SphereShade: return away_q ? ShadeHalf : ShadeLit;
    case SphereShadowFront: return !behind_q && (own_sphere() || inside_q) ? ShadeHalf : ShadeHold;
    case SphereShadowChord: return d_q < 0 ? ShadeHold : ShadeHalf;
    case SpherePlaneT:
      return shadow_q && in.divider_done && keeps_plane(in) ? ShadeHalf : ShadeHold;
    case SphereAdd: return ShadeAdd;
    case SphereNext: return stalled(in, k) ? ShadeHold : ShadeStore;
    default: return ShadeHold;
  }
}

void sphere_tracer_core::next_object(const inputs& in, bool hit) {
  if (object_q != in.sphere_last) {
    object_q = (object_q + 1) & low_bits(SphereIndexBits);
    state_q = SphereCentre;
  } else if (hit) {
    state_q = SphereLight;
  } else if (planes_follow(in)) {
    object_q = 0;
    shadow_q = false;
    state_q = SpherePlane;
  } else {
    state_q = SphereNext;
  }
}

void sphere_tracer_core::next_plane(const inputs& in, bool hit) {
  if ((object_q & low_bits(PlaneIndexBits)) != in.plane_last) {
    object_q = (object_q + 1) & low_bits(SphereIndexBits);
    state_q = SpherePlane;
  } else if (shadow_q) {
    state_q = SphereAdd;
  } else {
    state_q = hit ? SphereLray : SphereNext;
  }
}

void sphere_tracer_core::test_along(const inputs& in) {
  tca_q = floor24(in.vector.sum);
  behind_q = in.vector.sum < 0;
  inside_q = c2_q < wrap48(std::int64_t{in.sphere.radius2} << SphereBits);
}

void sphere_tracer_core::take_discriminant(const inputs& in) {
  d_q = wrap48(in.vector.square - c2_q + (std::int64_t{in.sphere.radius2} << SphereBits));
}

void sphere_tracer_core::take_sphere(const inputs& in, const sphere_knobs& k) {
  const int t = along(in) & low_bits(SphereBits);
  if (hit_q && t >= (t_q & low_bits(SphereBits))) return;
  t_q = wrap24(t);
  hit_q = true;
  hit_plane_q = false;
  hit_index_q = object_q;
  is_light_q = in.sphere.is_light;
  point_q = masked(sum_of(org_q, in.vector.product), kept_bits(k.fraction_bits));
  base_q = in.sphere.colour;
  dark_q = false;
  reflect_q = in.sphere.reflect;
}

void sphere_tracer_core::take_plane(const inputs& in, const sphere_knobs& k) {
  const vec3 p = sum_of(org_q, in.vector.product);
  t_q = in.quotient[0];
  hit_q = hit_plane_q = true;
  hit_index_q = object_q;
  is_light_q = false;
  point_q = masked(p, kept_bits(k.fraction_bits));
  base_q = in.plane.colour;
  reflect_q = in.plane.reflect;
  dark_q = ((p[0] ^ p[2]) >> SphereFraction & in.plane.checker) != 0;
}

void sphere_tracer_core::take_light(const inputs& in) {
  away_q = in.vector.sum < 0;
  const std::int64_t fraction = in.vector.sum >> SphereFraction;
  fraction_q = static_cast<int>(!away_q && fraction > 0xfff ? 0xfff : fraction & 0xfff);
}

void sphere_tracer_core::after_centre(const inputs& in, const sphere_knobs& k) {
  if (!no_shadow_test(in, k)) {
    c_q = difference(in.sphere.centre, point_q);
    c2_q = in.vector.sum;
    state_q = SphereShadowAlong;
  } else if (k.plane_shadows && planes_follow(in)) {
    object_q = 0;
    shadow_q = true;
    state_q = SpherePlane;
  } else {
    state_q = SphereAdd;
  }
}

void sphere_tracer_core::after_add(const inputs& in, const sphere_knobs& k) {
  const bool stop = nref_q == in.max_reflections || in.weight < k.min_weight || is_light_q;
  state_q = stop ? SphereNext : SphereReflect;
}

void sphere_tracer_core::after_next(const inputs& in, const sphere_knobs& k) {
  if (stalled(in, k)) return;
  state_q = SphereRay;
  nref_q = 0;
  if (sub_q != last_sub(in.alias)) {
    sub_q = (sub_q + 1) & 15;
    return;
  }
  sub_q = 0;
  if (x_q != k.columns(in.narrow) - 1) {
    x_q = (x_q + 1) & 1023;
    return;
  }
  x_q = 0;
  if (y_q != k.rows(in.narrow) - 1) {
    y_q = (y_q + 1) & 1023;
    return;
  }
  y_q = 0;
  state_q = SphereHost;
}

void sphere_tracer_core::clock(const inputs& in, const sphere_knobs& k) {
  if (!in.rst_n) {
    *this = {};
    return;
  }
  const int mask = kept_bits(k.fraction_bits);
  switch (state_q) {
    case SphereHost:
      if (!in.loaded) break;
      x_q = y_q = sub_q = nref_q = 0;
      state_q = SphereRay;
      break;
    case SphereRay:
      if (nref_q == 0) {
        dir_q = masked(in.direction, mask);
        org_q = in.origin;
      }
      start_root(length_radicand(in.vector.sum));
      state_q = SphereRoot;
      break;
    case SphereRoot:
    case SphereLroot:
      if (!in.root_done) break;
      length_q = in.root;
      root_start_q = false;
      divider_start_q = true;
      state_q = state_q == SphereRoot ? SphereDivide : SphereLdivide;
      break;
    case SphereDivide:
      if (!in.divider_done) break;
      dir_q = masked(in.quotient, mask);
      divider_start_q = false;
      object_q = 0;
      hit_q = false;
      state_q = SphereCentre;
      break;
    case SphereCentre:
      c_q = difference(in.sphere.centre, org_q);
      c2_q = in.vector.sum;
      state_q = SphereAlong;
      break;
    case SphereAlong:
      test_along(in);
      state_q = inside_q && nref_q == 0 ? SphereNext : SphereFront;
      break;
    case SphereFront:
      take_discriminant(in);
      state_q = SphereChord;
      if (behind_q) next_object(in, hit_q);
      break;
    case SphereChord:
      if (d_q < 0) {
        next_object(in, hit_q);
      } else {
        start_root(static_cast<int>(d_q >> SphereFraction & low_bits(SphereBits)));
        state_q = SphereWait;
      }
      break;
    case SphereWait: state_q = SphereHit; break;
    case SphereHit:
      if (!in.root_done) break;
      root_start_q = false;
      take_sphere(in, k);
      next_object(in, true);
      break;
    case SpherePlane:
      vd_q = floor24(in.vector.sum);
      if (in.vector.sum >= 0) next_plane(in, hit_q);
      else state_q = SpherePlaneD;
      break;
    case SpherePlaneD:
      vo_q = wrap24(-floor24(in.vector.sum) - in.plane.distance);
      divider_start_q = true;
      state_q = SpherePlaneT;
      break;
    case SpherePlaneT: {
      if (!in.divider_done) break;
      divider_start_q = false;
      const bool keeps = keeps_plane(in);
      if (shadow_q && keeps) {
        state_q = SphereAdd;
        break;
      }
      if (keeps) take_plane(in, k);
      next_plane(in, hit_q);
      break;
    }
    case SphereLight: state_q = is_light_q ? SphereAdd : SphereLray; break;
    case SphereLray:
      lray_q = towards_light(in.light, point_q, kept_bits(k.fraction_bits));
      start_root(length_radicand(in.vector.sum));
      state_q = SphereLroot;
      break;
    case SphereLdivide:
      if (!in.divider_done) break;
      lray_q = masked(in.quotient, mask);
      divider_start_q = false;
      object_q = 0;
      state_q = SphereNormal;
      break;
    case SphereNormal:
      normal_q = hit_plane_q ? in.plane.normal : in.vector.product;
      state_q = SphereLambert;
      break;
    case SphereLambert:
      take_light(in);
      state_q = hit_plane_q ? SphereShadowCentre : SphereShade;
      break;
    case SphereShade: state_q = away_q ? SphereAdd : SphereShadowCentre; break;
    case SphereShadowCentre: after_centre(in, k); break;
    case SphereShadowAlong:
      test_along(in);
      state_q = SphereShadowFront;
      break;
    case SphereShadowFront:
      take_discriminant(in);
      if (behind_q) next_sphere();
      else if (own_sphere() || inside_q) state_q = SphereAdd;
      else if (tca_q > distance()) next_sphere();
      else state_q = SphereShadowChord;
      break;
    case SphereShadowChord:
      if (d_q < 0) next_sphere();
      else state_q = SphereAdd;
      break;
    case SphereAdd: after_add(in, k); break;
    case SphereReflect:
      if (stalled(in, k)) break;
      n2_q = wrap24(static_cast<int>(in.vector.sum >> (SphereFraction - 1)));
      state_q = SphereReflectTwo;
      break;
    case SphereReflectTwo:
      dir_q = masked(difference(dir_q, in.vector.product), mask);
      org_q = point_q;
      nref_q = (nref_q + 1) & 3;
      state_q = SphereRay;
      break;
    case SphereNext: after_next(in, k); break;
    default: state_q = SphereRay; break;
  }
}

}  // namespace racebeam
