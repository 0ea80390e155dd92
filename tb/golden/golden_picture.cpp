// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_picture.h"

#include <algorithm>
#include <cmath>

#include "tb/golden/geometry.h"
#include "tb/golden/tracer_2.h"
#include "tb/golden/tracer_3.h"
#include "tb/golden/tracer_4.h"

namespace racebeam {

namespace {

/// Shading B (contract 15.1): by axis, side, and odd line.
constexpr int ShadingB[3][2][2] = {{{0, 1}, {3, 3}}, {{1, 1}, {2, 3}}, {{1, 2}, {2, 2}}};

/// Two bits of a ray's component, `low` the number of the lower.
int bits(int component, int low) { return component >> low & 3; }

bool shows_pattern(const GoldenWorld& world, const vec3& dr) {
  if (world.lock == GoldenLock::Partial) return bits(dr[1], 6) != 0;
  return world.lock == GoldenLock::Full;
}

/// Whether shading B shows the brighter of two indices.
bool brighter(const GoldenWorld& world, int column, int y) {
  if (world.dithering == DitheringCheckered) return (column + y) & 1;
  return world.dithering == DitheringOn && (y & 1);
}

std::uint8_t shown(const GoldenWorld& world, const vec3& dr, const GoldenHit* hit, int column,
                   int y) {
  const bool pattern = shows_pattern(world, dr);
  int index = 0;
  if (pattern) {
    index = (bits(dr[0], 5) | bits(dr[2], 4)) & bits(dr[1], 6);
  } else if (hit) {
    index = world.shading_b ? ShadingB[hit->face][hit->negative][brighter(world, column, y)]
                            : 3 - hit->face;
  }
  if (world.inverse && index >= 2) index = 5 - index;
  return (pattern ? world.pattern_palette : world.palette)[index];
}

GoldenRays whole(const GoldenIdeal& camera) {
  GoldenRays rays;
  for (int p = 0; p < VisibleColumns; ++p)
    for (int a = 0; a < 3; ++a) rays[p][a] = static_cast<int>(std::floor(camera.ray(p)[a]));
  return rays;
}

/// A line of a tracer that takes the chip's rays.
GoldenHits traced_line(GoldenTracer tracer, const GoldenWorld& world, const GoldenRays& rays, int y,
                       GoldenWork* work) {
  if (tracer == GoldenTracer::Trace2) return trace_2_line(world, rays, y, work);
  if (tracer == GoldenTracer::Trace3) return trace_3_line(world, rays, y, work);
  return trace_4_line(world, rays, y, work);
}

}  // namespace

const std::vector<std::string>& golden_tracer_names() {
  static const std::vector<std::string> names = {"trace2", "trace4", "geometry", "trace3"};
  return names;
}

GoldenPicture golden_picture(GoldenTracer tracer, const GoldenWorld& world,
                             const GoldenCamera& camera, GoldenWork* work) {
  GoldenPicture picture;
  picture.reserve(VisibleColumns * VisibleRows);
  for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; ++y) {
    const bool is_ideal = tracer == GoldenTracer::Geometry;
    GoldenRays rays{};  // geometry needs none but for the pattern
    if (!is_ideal) rays = camera.rays(y);
    else if (world.lock != GoldenLock::None) rays = whole(camera.ideal(y));
    GoldenHits hits{};
    const std::uint64_t clocks = work ? work->clocks : 0;
    if (world.lock != GoldenLock::Full)
      hits = is_ideal ? geometry_line(world, camera.ideal(y), y)
                      : traced_line(tracer, world, rays, y, work);
    if (work) work->line_clocks.push_back(static_cast<int>(work->clocks - clocks));
    for (int column = 0; column < VisibleColumns; ++column)
      picture.push_back(
          shown(world, rays[column], column ? &hits[column - 1] : nullptr, column, y));
  }
  return picture;
}

int golden_difference(const GoldenPicture& a, const GoldenPicture& b) {
  constexpr std::size_t Part = 192;  // a byte counts it, so the compiler takes many pixels at once
  int differing = 0;
  for (std::size_t begin = 0; begin < a.size(); begin += Part) {
    const std::size_t end = std::min(begin + Part, a.size());
    std::uint8_t part = 0;
    for (std::size_t i = begin; i < end; ++i)
      part = static_cast<std::uint8_t>(part + (a[i] != b[i]));
    differing += part;
  }
  return differing;
}

}  // namespace racebeam
