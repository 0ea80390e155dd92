// Scene quad of the block renderer: four spheres, as its cores and its host see them; and
// what a core makes of a pixel, written from the design in one piece.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "sc/block/numbers.h"
#include "tests/support/block_scenes.h"

namespace racebeam {

inline const block_tables& quad() {
  static const block_tables tables = quad_tables();
  return tables;
}
constexpr int QuadStep = 0x3333;  // 8 / 640 and 6 / 480

inline vec3 fixed_axes(const std::array<float, 3>& v) { return {f2i(v[0]), f2i(v[1]), f2i(v[2])}; }
/// Where block (0, 0) begins on the screen.
inline vec3 quad_start() {
  const vec3 eye = fixed_axes(quad().eye);
  return {-f2i(quad().screen[0]) / 2 - eye[0], f2i(quad().screen[1]) / 2 - eye[1], -eye[2]};
}
inline int quad_radius2(const block_ball& s) { return imul(f2i(s.radius), f2i(s.radius)); }
inline int quad_rv(const block_ball& s) {
  return quad_radius2(s) - inorm2(block_difference(fixed_axes(quad().eye), fixed_axes(s.centre)));
}

/// The channels of pixel (x, y), and the clocks from PIXEL to STORE with four lanes.
struct quad_pixel {
  std::array<int, 3> rgb;
  int clocks;
};
inline quad_pixel draw_quad_pixel(int x, int y, int passes = 3, int background = 0,
                                  bool shadow_rays = false) {
  const int one = 1 << BlockFraction;
  vec3 at = quad_start();
  at[0] += x * QuadStep;
  at[1] -= y * QuadStep;
  vec3 position = fixed_axes(quad().eye), dir = inormalize(at, 2), colour{};
  int clocks = 9, pass = 0;
  for (; pass < passes; ++pass) {
    int best = BlockFar << BlockFraction;
    const block_ball* hit = nullptr;
    clocks += pass == 0 ? 1 : 2;
    for (const block_ball& s : quad().balls) {
      const vec3 way = block_difference(position, fixed_axes(s.centre));
      const int b = idot(way, dir);
      const int d = imul(b, b) - inorm2(way) + quad_radius2(s);
      if (d <= 0) continue;
      ++clocks;
      const int t = -b - isqrt(d);
      if (t <= 0 || t >= best) continue;
      best = t;
      hit = &s;
    }
    ++clocks;
    if (!hit) break;
    clocks += 13 + 2 * 9;
    position = block_sum(position, imul(dir, best));
    const vec3 normal = inormalize(block_difference(position, fixed_axes(hit->centre)), 2);
    const vec3 to_light = block_difference(fixed_axes(quad().light), position);
    const vec3 light = inormalize(to_light, 2);
    const int diffuse = std::max(idot(normal, light), 0);
    int bright =
        std::max(idot(dir, block_difference(light, imul(normal, imul(diffuse, 2 * one)))), 0);
    for (int n = 0; n < 4; ++n) bright = imul(bright, bright);
    bool dark = false;
    if (shadow_rays) {
      const int length = idot(to_light, light);
      clocks += 9 + 1 + 2;
      for (const block_ball& s : quad().balls) {
        if (&s == hit || dark) continue;
        const vec3 way = block_difference(position, fixed_axes(s.centre));
        const int b = idot(way, light);
        const int d = imul(b, b) - inorm2(way) + quad_radius2(s);
        if (d <= 0) continue;
        ++clocks;
        const int t = -b - isqrt(d);
        dark = t > 0 && t < length;
      }
    }
    for (std::size_t k = 0; k < 3 && !dark; ++k)
      colour[k] += imul(f2i(hit->colour[k]), diffuse) + bright;
    dir = block_difference(dir, imul(normal, imul(idot(dir, normal), 2 * one)));
  }
  quad_pixel out{{}, clocks + 1};
  for (int k = 0; k < 3; ++k)
    out.rgb[static_cast<std::size_t>(k)] =
        pass == 0 ? background >> (16 - 8 * k) & 255 : std::min(colour[k] >> 12, 255);
  return out;
}

}  // namespace racebeam
