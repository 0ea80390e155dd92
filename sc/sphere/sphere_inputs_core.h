// Behaviour of sphere_inputs (sphere_inputs.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/sphere/numbers.h"
#include "sc/sphere/sphere_scene.h"

namespace racebeam {

struct sphere_inputs_core {
  vec3 origin_q{}, light_q{};
  int screen_q = 0;
  int rotz_q = 0;
  int max_reflections_q = 0, alias_q = 0;
  bool narrow_q = false, scene_q = false, planes_q = false;

  struct inputs {
    bool rst_n;
    int sw, key_n;
    bool picture_done;
  };

  static bool rst_n(const inputs& in) { return in.rst_n && bit_of(in.key_n, 3); }

  void clock(const inputs& in, const sphere_start& start) {
    if (!rst_n(in)) {
      origin_q = start.origin;
      light_q = start.light;
      screen_q = start.screen;
      rotz_q = 0;
      planes_q = !bit_of(in.key_n, 2);
      take_modes(in.sw);
    } else if (in.picture_done) {
      rotz_q = 0;
      for (int axis = 0; axis < 3; ++axis) {
        move(light_q[axis], in.sw, 17 - 2 * axis, 5 - axis);
        move(origin_q[axis], in.sw, 11 - 2 * axis, 2 - axis);
      }
      screen_q =
          wrap24(screen_q + (bit_of(in.key_n, 0) ? 0 : 256) - (bit_of(in.key_n, 1) ? 0 : 256));
      take_modes(in.sw);
    }
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    static constexpr char axis[] = {'x', 'y', 'z'};
    for (int n = 0; n < 3; ++n) {
      visit(std::string("origin_") + axis[n] + "_q", SphereBits, [this, n] { return origin_q[n]; });
      visit(std::string("light_") + axis[n] + "_q", SphereBits, [this, n] { return light_q[n]; });
    }
    visit("screen_q", SphereBits, [this] { return screen_q; });
    visit("rotz_q", 6, [this] { return rotz_q; });
    visit("max_reflections_q", 2, [this] { return max_reflections_q; });
    visit("alias_q", 2, [this] { return alias_q; });
    visit("narrow_q", 1, [this] { return narrow_q; });
    visit("scene_q", 1, [this] { return scene_q; });
    visit("planes_q", 1, [this] { return planes_q; });
  }

 private:
  void move(int& value, int sw, int plus, int turn) {
    const int up = bit_of(sw, plus), down = bit_of(sw, plus - 1);
    if (up && down) rotz_q |= 1 << turn;
    else value = wrap24(value + (up - down) * 4096);
  }
  void take_modes(int sw) {
    narrow_q = !bit_of(sw, 5);
    scene_q = bit_of(sw, 4);
    max_reflections_q = sw >> 2 & 3;
    alias_q = bit_of(sw, 1) ? 2 : bit_of(sw, 0);
  }
};

}  // namespace racebeam
