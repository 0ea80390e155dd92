// Arithmetic of the voxel tracer: positions signed 16.8, directions signed 2.16, inverses of
// directions 12.20, and the ray's parameter t, 24.8 and never less than 0.
//
// A ray is at t where it has gone t times its direction from its origin. A border's t is always
// found from the origin, so it never falls.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "sc/base/fixed_point.h"
#include "sc/voxel/codes.h"

namespace racebeam {

constexpr std::int64_t VoxelNever = std::int64_t{1} << 31;  ///< as t: no border is met

/// Units from the origin in which positions lie, to both sides.
constexpr int VoxelFarAway = 1 << (VoxelPositionBits - VoxelPositionFraction - 1);

constexpr bool voxel_parallel(int direction) {
  return (direction < 0 ? -direction : direction) < VoxelParallel;
}

/// 2^36 / |direction|, rounded down, at most 2^32 - 1; 0 of a parallel one.
constexpr std::uint32_t voxel_inverse(int direction) {
  if (voxel_parallel(direction)) return 0;
  const std::uint64_t size = static_cast<std::uint64_t>(direction < 0 ? -direction : direction);
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>((std::uint64_t{1} << 36) / size, 0xffffffffu));
}

/// A whole coordinate as a position.
constexpr int voxel_position(int whole) { return whole * (1 << VoxelPositionFraction); }

/// t of the border at the whole coordinate `border` of an axis.
constexpr std::int64_t voxel_border_t(int border, int origin, int direction,
                                      std::uint32_t inverse) {
  if (voxel_parallel(direction)) return VoxelNever;
  std::int64_t delta = voxel_position(border) - origin;
  if (direction < 0) delta = -delta;
  // |delta| < 2^25, so the product holds in 64 bits.
  const std::int64_t t = (delta * static_cast<std::int64_t>(inverse)) >> VoxelInverseFraction;
  return std::clamp<std::int64_t>(t, 0, VoxelNever);
}

/// Where the ray is at t on an axis, 16.8, rounded down, modulo 2^16.
constexpr int voxel_point(int origin, std::int64_t t, int direction) {
  const std::int64_t moved = (t * direction) >> VoxelDirectionFraction;
  return wrap_signed(static_cast<int>(origin + moved), VoxelPositionBits);
}
constexpr vec3 voxel_point(const vec3& origin, std::int64_t t, const vec3& direction) {
  return {voxel_point(origin[0], t, direction[0]), voxel_point(origin[1], t, direction[1]),
          voxel_point(origin[2], t, direction[2])};
}

/// Between samples, 24.8: a unit along the longest axis, `steps` to it. 2^32 - 1 of no direction.
constexpr std::uint32_t voxel_step_of(const vec3& direction,
                                      const std::array<std::uint32_t, 3>& inverse, int steps) {
  std::uint32_t step = 0xffffffff;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!voxel_parallel(direction[axis]))
      step = std::min(step, inverse[axis] >> (VoxelInverseFraction - VoxelPositionFraction));
  return step / static_cast<std::uint32_t>(steps);
}

/// Whether a point of 16.8 is in the solid of its column.
constexpr bool voxel_solid(int low, int middle, int high, int z) {
  const int at = z >> VoxelPositionFraction;
  return at < low || (at >= middle && at < high);
}

}  // namespace racebeam
