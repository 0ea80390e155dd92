// Hits of golden tracers compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "tb/golden/geometry.h"
#include "tb/golden/tracer_2.h"

namespace racebeam {

inline bool same_hit(const GoldenHit& a, const GoldenHit& b) {
  return a.face == b.face && a.negative == b.negative;
}

/// Does the ray go so near an edge that a nudge changes what it hits?
inline bool on_edge(const GoldenWorld& world, const GoldenVector& ray, int offset_z) {
  const GoldenHit hit = geometry(world, ray, offset_z);
  for (int a = 0; a < 3; ++a)
    for (const double nudge : {-1e-4, 1e-4}) {
      GoldenVector near = ray;
      near[a] += nudge;
      if (!same_hit(geometry(world, near, offset_z), hit)) return true;
    }
  return false;
}

/// Gives both the chip's rays of each `every`th line, and corners of any size.
inline void expect_trace_2_agrees_with_geometry(GoldenWorld world, const GoldenCamera& camera,
                                                int every) {
  world.corner_bits = 0;
  for (int y = -240; y < 240; y += every) {
    const GoldenRays rays = camera.rays(y);
    const int z = world.offset_z(y);
    for (int p = 0; p < VisibleColumns; ++p) {
      GoldenVector ray;
      for (int a = 0; a < 3; ++a)
        ray[a] = rays[p][a] < 0 ? rays[p][a] + 1 - 1e-7 : rays[p][a] + 1e-7;
      if (same_hit(trace_2(world, rays[p], z), geometry(world, ray, z))) continue;
      ASSERT_TRUE(on_edge(world, ray, z)) << "line " << y << " pixel " << p;
    }
  }
}

}  // namespace racebeam
