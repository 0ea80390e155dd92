// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_tracer.h"

namespace racebeam {

namespace {

/// From a hit towards the light: one and a half units on, or the ray would begin in the ground.
vec3 shadow_origin(const vec3& hit, const vec3& light) {
  vec3 from;
  for (std::size_t axis = 0; axis < 3; ++axis)
    from[axis] = wrap_signed(hit[axis] + (3 * light[axis] >> 9), VoxelPositionBits);
  return from;
}

}  // namespace

vec3 voxel_direction(const voxel_view& view, int x, int y) {
  constexpr int Cut = 8;  // fraction bits of the sums that a direction has not
  vec3 direction;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto sum = static_cast<std::uint32_t>(view.d00[axis]) +
                     static_cast<std::uint32_t>(x) * static_cast<std::uint32_t>(view.dx[axis]) +
                     static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(view.dy[axis]);
    direction[axis] = wrap_signed(static_cast<int>(sum) >> Cut, VoxelDirectionBits);
  }
  return direction;
}

voxel_drawn voxel_tracer::draw(const voxel_view& view, int x, int y, voxel_counters& n) const {
  const voxel_ray ray{view.origin, voxel_direction(view, x, y)};
  const std::uint64_t before = n.walked.clocks;
  const voxel_end end = voxel_walk(world_, k_, ray, {k_.max_outer, k_.max_inner}, n.walked);
  const std::uint64_t walked = n.walked.clocks;
  ++n.ends[end.kind];
  bool shadowed = false;
  if (k_.shadows && end.kind == VoxelHit) {
    const voxel_ray towards{shadow_origin(end.position, view.light), view.light};
    const voxel_limit limit{k_.shadow_outer, k_.shadow_inner};
    shadowed = voxel_walk(world_, k_, towards, limit, n.walked).kind == VoxelHit;
    ++n.shadow_rays;
    n.shadowed += shadowed;
  }
  const voxel_shaded shaded =
      voxel_shade_pixel(world_, palette_, k_, {end.kind, end.position, ray.direction[2], shadowed});
  n.walk_clocks += walked - before;
  n.shadow_clocks += n.walked.clocks - walked;
  n.shade_clocks += static_cast<unsigned>(shaded.clocks);
  n.shade_reads += static_cast<unsigned>(shaded.reads);
  return {end, shadowed, shaded.colour, static_cast<int>(n.walked.clocks - before) + shaded.clocks};
}

}  // namespace racebeam
