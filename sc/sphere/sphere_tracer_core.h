// Behaviour of sphere_tracer (sphere_tracer.h), clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sc/base/probe.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/numbers.h"
#include "sc/sphere/sphere_scene.h"
#include "sc/sphere/vector_unit_core.h"

namespace racebeam {

struct sphere_tracer_core {
  int state_q = SphereHost;
  int x_q = 0, y_q = 0, sub_q = 0;
  int nref_q = 0;    // reflections before this ray
  int object_q = 0;  // under test
  bool hit_q = false, hit_plane_q = false, is_light_q = false;
  int hit_index_q = 0;
  bool inside_q = false, behind_q = false, away_q = false, shadow_q = false;
  vec3 dir_q{}, org_q{}, point_q{}, lray_q{}, normal_q{}, c_q{};
  std::int64_t c2_q = 0, d_q = 0;
  int tca_q = 0, t_q = 0, n2_q = 0, vd_q = 0, vo_q = 0;
  int length_q = 0, radicand_q = 0;
  bool root_start_q = false, divider_start_q = false;
  int fraction_q = 0;
  sphere_colour base_q{};
  bool dark_q = false;
  int reflect_q = 0;

  struct inputs {
    bool rst_n;
    vec3 origin, light;
    int max_reflections, alias;
    bool narrow, planes;
    bool loaded;
    vec3 direction;
    sphere_row sphere;  // at sphere_index()
    int sphere_last;
    plane_row plane;  // at plane_index()
    int plane_last;
    bool plane_empty;
    vector_unit_core::outputs vector;
    int root;
    bool root_done;
    vec3 quotient;
    bool divider_done;
    int weight;
    bool word_ready;
  };

  int sphere_index() const;
  int plane_index() const;
  int address(const sphere_knobs& k) const {
    return (y_q & 511) << (k.wide ? 10 : 9) | (x_q & (k.wide ? 1023 : 511));
  }
  std::array<std::int64_t, 3> numerator() const;
  int denominator() const;
  int op() const;
  /// A clock with these inputs changes nothing; of them the reset, loaded and both `done` count.
  bool waits(const inputs& in) const {
    if (!in.rst_n) return false;
    switch (state_q) {
      case SphereHost: return !in.loaded;
      case SphereRoot:
      case SphereLroot:
      case SphereHit: return !in.root_done;
      case SphereDivide:
      case SphereLdivide:
      case SpherePlaneT: return !in.divider_done;
      default: return false;
    }
  }
  /// What vector_unit multiplies; inputs::vector must answer it.
  vector_unit_core::inputs asks(const inputs& in, const sphere_knobs& k) const;
  /// `word_valid`: with inputs::alias.
  bool word_valid(int alias, const sphere_knobs& k) const;
  int shader(const inputs& in, const sphere_knobs& k) const;
  bool picture_done(const inputs& in, const sphere_knobs& k) const {
    return state_q == SphereNext && !stalled(in, k) && last_of_picture(in, k);
  }
  void clock(const inputs& in, const sphere_knobs& k);

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    const auto axes3 = [&visit](const char* stem, const vec3& v) {
      const int* at = v.data();
      for (int n = 0; n < 3; ++n)
        visit(std::string(stem) + "_" + "xyz"[n] + "_q", SphereBits, [at, n] { return at[n]; });
    };
    visit("state_q", SphereStateBits, [this] { return state_q; });
    visit("x_q", 10, [this] { return x_q; });
    visit("y_q", 10, [this] { return y_q; });
    visit("sub_q", 4, [this] { return sub_q; });
    visit("nref_q", 2, [this] { return nref_q; });
    visit("object_q", SphereIndexBits, [this] { return object_q; });
    visit("hit_q", 1, [this] { return hit_q; });
    visit("hit_plane_q", 1, [this] { return hit_plane_q; });
    visit("hit_index_q", SphereIndexBits, [this] { return hit_index_q; });
    visit("is_light_q", 1, [this] { return is_light_q; });
    visit("inside_q", 1, [this] { return inside_q; });
    visit("behind_q", 1, [this] { return behind_q; });
    visit("away_q", 1, [this] { return away_q; });
    visit("shadow_q", 1, [this] { return shadow_q; });
    axes3("dir", dir_q);
    axes3("org", org_q);
    axes3("point", point_q);
    axes3("lray", lray_q);
    axes3("normal", normal_q);
    axes3("c", c_q);
    visit("c2_q", SphereSumBits, [this] { return c2_q; });
    visit("d_q", SphereSumBits, [this] { return d_q; });
    visit("tca_q", SphereBits, [this] { return tca_q; });
    visit("t_q", SphereBits, [this] { return t_q; });
    visit("n2_q", SphereBits, [this] { return n2_q; });
    visit("vd_q", SphereBits, [this] { return vd_q; });
    visit("vo_q", SphereBits, [this] { return vo_q; });
    visit("length_q", SphereBits, [this] { return length_q; });
    visit("radicand_q", SphereBits, [this] { return radicand_q; });
    visit("root_start_q", 1, [this] { return root_start_q; });
    visit("divider_start_q", 1, [this] { return divider_start_q; });
    visit("fraction_q", UnitBits, [this] { return fraction_q; });
    visit("base_q", 3 * SphereColourBits, [this] {
      return (base_q[0] << SphereColourBits | base_q[1]) << SphereColourBits | base_q[2];
    });
    visit("dark_q", 1, [this] { return dark_q; });
    visit("reflect_q", UnitBits, [this] { return reflect_q; });
  }

 private:
  bool stalled(const inputs& in, const sphere_knobs& k) const {
    return word_valid(in.alias, k) && !in.word_ready;
  }
  bool last_of_picture(const inputs& in, const sphere_knobs& k) const;
  const vec3& ray() const { return shadow_q ? lray_q : dir_q; }
  const vec3& start() const { return shadow_q ? point_q : org_q; }
  int along(const inputs& in) const { return inside_q ? tca_q + in.root : tca_q - in.root; }
  bool planes_follow(const inputs& in) const { return in.planes && !in.plane_empty; }
  bool no_shadow_test(const inputs& in, const sphere_knobs& k) const {
    return object_q == in.sphere_last || !k.shadow_rays;
  }
  int distance() const { return wrap24(length_q << 4); }  // to the light
  bool own_sphere() const { return !hit_plane_q && object_q == hit_index_q; }
  bool keeps_plane(const inputs& in) const;

  void next_object(const inputs& in, bool hit);
  void next_plane(const inputs& in, bool hit);
  void next_sphere() {
    object_q = (object_q + 1) & low_bits(SphereIndexBits);
    state_q = SphereShadowCentre;
  }
  void test_along(const inputs& in);
  void take_discriminant(const inputs& in);
  void take_sphere(const inputs& in, const sphere_knobs& k);
  void take_plane(const inputs& in, const sphere_knobs& k);
  void take_light(const inputs& in);
  void start_root(int radicand) {
    radicand_q = radicand;
    root_start_q = true;
  }
  void after_centre(const inputs& in, const sphere_knobs& k);
  void after_add(const inputs& in, const sphere_knobs& k);
  void after_next(const inputs& in, const sphere_knobs& k);
};

}  // namespace racebeam
