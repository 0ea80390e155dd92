// sphere_rays: the pixels of a picture, ray by ray: what sphere_tracer and the units around it make
// of them, and in how many clocks, whole states at once.
//
// A closed form of sphere_tracer_core for the tlm level: the same words, clocks and counters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/sphere/counters.h"
#include "sc/sphere/sphere_inputs_core.h"
#include "sc/sphere/sphere_raygen_core.h"
#include "sc/sphere/sphere_shader_core.h"
#include "sc/sphere/sphere_table_core.h"

namespace racebeam {

/// Nobody listens to the states of a pixel.
struct no_sphere_log {
  void operator()(int, int, int, const char*) const {}
};

class sphere_rays {
 public:
  /// All must outlive it, and stay as they are while a pixel is drawn.
  sphere_rays(const sphere_knobs& k, const sphere_table_core& spheres,
              const std::vector<plane_row>& planes, const sphere_inputs_core& inputs)
      : k_(k), mask_(kept_bits(k.fraction_bits)), spheres_(spheres), planes_(planes), in_(inputs) {}

  /// Draws a pixel; the clocks that it takes, from its first RAY to its last NEXT.
  /// `log(state, clocks, object, what)` hears each stay in a state, -1 for no object.
  /// `offer(clock, word)`: a word at so many clocks after the first RAY; answers how many clocks it
  /// waits.
  template <class Log, class Offer>
  int pixel(int x, int y, Log&& log, Offer&& offer);

  /// Adds what was counted since the last call, but for what the write buffer and the raster do.
  void take(sphere_counters& to);
  /// The word of the pixel that is being drawn, if this were all.
  std::uint64_t so_far() const { return shader_.word(sub_, in_.alias_q, k_); }

 private:
  struct ray {
    vec3 dir, org;
    int nref;
    bool hit, hit_plane, is_light;
    int t, index;  // of what it hit
    vec3 point, normal;
    sphere_colour base;
    bool dark;
    int reflect;
  };

  /// Whether the sub-ray is black without more ado.
  template <class Log>
  bool meet_spheres(ray& r, Log& log);
  template <class Log>
  void meet_planes(ray& r, Log& log);
  template <class Log>
  void light(ray& r, Log& log);
  template <class Log>
  bool in_shadow(const ray& r, const vec3& lray, int distance, Log& log);
  template <class Log>
  bool behind_plane(const ray& r, const vec3& lray, int distance, Log& log);
  template <class Log, class Offer>
  void sub_ray(int x, int y, int sub, Log& log, Offer& offer);

  template <class Log>
  void stay(Log& log, int state, int clocks, int object, const char* what) {
    clocks_ += clocks;
    states_[state] += static_cast<unsigned>(clocks);
    log(state, clocks, object, what);
  }
  int shade(int op, const ray& r, int fraction, int sub) {
    shader_.clock({true, op, r.base, r.dark, fraction, r.reflect, r.nref == 0, sub, in_.alias_q});
    return op;
  }
  /// The root of the squared length, and the ray over it.
  int normalise(vec3& ray) {
    const std::int64_t sum = dot(ray, ray);
    n_.overflows += length_overflows(sum);
    const int length = root_of(length_radicand(sum));
    for (int& each : ray) each = quotient_of(std::int64_t{each} * 4096, length) & mask_;
    ++n_.roots;
    n_.divisions += 3;
    return length;
  }
  vec3 point_of(const vec3& from, const vec3& ray, int t) const {
    return sum_of(from, scaled(ray, wrap24(t)));
  }

  const sphere_knobs& k_;
  const int mask_;
  const sphere_table_core& spheres_;
  const std::vector<plane_row>& planes_;
  const sphere_inputs_core& in_;
  sphere_shader_core shader_;
  int sub_ = 0;
  int clocks_ = 0;  // of this pixel
  sphere_counters n_;
  std::uint64_t states_[SphereStates]{};
};

}  // namespace racebeam

#include "sc/sphere/sphere_rays_body.h"
