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
#include <cstdint>
#include <cstdlib>

#include "sc/base/fixed_point.h"
#include "sc/voxel/codes.h"

namespace racebeam {

constexpr std::int64_t VoxelNever = std::int64_t{1} << 31;  ///< as t: no border is met

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

/// t of the border at the whole coordinate `border` of an axis.
constexpr std::int64_t voxel_border_t(int border, int origin, int direction,
                                      std::uint32_t inverse) {
  if (voxel_parallel(direction)) return VoxelNever;
  std::int64_t delta = (std::int64_t{border} << VoxelPositionFraction) - origin;
  if (direction < 0) delta = -delta;
  // |delta| < 2^25, so the product holds in 64 bits.
  const std::int64_t t = (delta * static_cast<std::int64_t>(inverse)) >> VoxelInverseFraction;
  return std::clamp<std::int64_t>(t, 0, VoxelNever);
}

/// Where the ray is at t on an axis, 16.8, rounded down; wider than a position far away.
constexpr std::int64_t voxel_point(int origin, std::int64_t t, int direction) {
  return origin + ((t * direction) >> VoxelDirectionFraction);
}

}  // namespace racebeam
