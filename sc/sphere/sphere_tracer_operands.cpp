// What a state looks up in the tables, multiplies and divides: sphere_tracer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_tracer_core.h"

namespace racebeam {

namespace {

bool tests_sphere(int state) {
  switch (state) {
    case SphereCentre:
    case SphereAlong:
    case SphereFront:
    case SphereHit:
    case SphereShadowCentre:
    case SphereShadowAlong:
    case SphereShadowFront: return true;
    default: return false;
  }
}

bool tests_plane(int state) {
  return state == SpherePlane || state == SpherePlaneD || state == SpherePlaneT;
}

}  // namespace

int sphere_tracer_core::sphere_index() const {
  return tests_sphere(state_q) ? object_q : hit_index_q;
}

int sphere_tracer_core::plane_index() const {
  return (tests_plane(state_q) ? object_q : hit_index_q) & low_bits(PlaneIndexBits);
}

std::array<std::int64_t, 3> sphere_tracer_core::numerator() const {
  const auto wide = [](const vec3& v) {
    return std::array<std::int64_t, 3>{std::int64_t{v[0]} * 4096, std::int64_t{v[1]} * 4096,
                                       std::int64_t{v[2]} * 4096};
  };
  if (state_q == SphereDivide) return wide(dir_q);
  if (state_q == SphereLdivide) return wide(lray_q);
  if (state_q == SpherePlaneT) return wide({vo_q, 0, 0});
  return {};
}

int sphere_tracer_core::denominator() const {
  if (state_q == SphereDivide || state_q == SphereLdivide) return length_q;
  return state_q == SpherePlaneT ? vd_q : 0;
}

int sphere_tracer_core::op() const {
  switch (state_q) {
    case SphereFront:
    case SphereShadowFront: return VectorSquare;
    case SphereHit:
    case SpherePlaneT:
    case SphereReflectTwo: return VectorScale;
    case SphereNormal: return hit_plane_q ? VectorDot : VectorScale;
    default: return VectorDot;
  }
}

vector_unit_core::inputs sphere_tracer_core::asks(const inputs& in, const sphere_knobs& k) const {
  const int op_now = op();
  const auto dot_of = [op_now](const vec3& a, const vec3& b) {
    return vector_unit_core::inputs{op_now, a, b, 0};
  };
  const auto scale_of = [op_now](const vec3& a, int s) {
    return vector_unit_core::inputs{op_now, a, {}, s};
  };
  switch (state_q) {
    case SphereRay: {
      const vec3 d = nref_q ? dir_q : masked(in.direction, kept_bits(k.fraction_bits));
      return dot_of(d, d);
    }
    case SphereCentre: {
      const vec3 c = difference(in.sphere.centre, org_q);
      return dot_of(c, c);
    }
    case SphereShadowCentre: {
      const vec3 c = difference(in.sphere.centre, point_q);
      return dot_of(c, c);
    }
    case SphereAlong: return dot_of(dir_q, c_q);
    case SphereShadowAlong: return dot_of(lray_q, c_q);
    case SphereFront:
    case SphereShadowFront: return scale_of({}, tca_q);
    case SphereHit: return scale_of(dir_q, wrap24(along(in)));
    case SpherePlane: return dot_of(in.plane.normal, ray());
    case SpherePlaneD: return dot_of(in.plane.normal, start());
    case SpherePlaneT: return scale_of(ray(), in.quotient[0]);
    case SphereLray: {
      const vec3 l = towards_light(in.light, point_q, kept_bits(k.fraction_bits));
      return dot_of(l, l);
    }
    case SphereNormal:
      if (hit_plane_q) break;
      return scale_of(difference(point_q, in.sphere.centre), in.sphere.inverse);
    case SphereLambert: return dot_of(normal_q, lray_q);
    case SphereReflect: return dot_of(dir_q, normal_q);
    case SphereReflectTwo: return scale_of(normal_q, n2_q);
    default: break;
  }
  return {op_now, {}, {}, 0};
}

}  // namespace racebeam
