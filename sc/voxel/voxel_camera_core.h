// Behaviour of voxel_camera (voxel_camera.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "sc/voxel/numbers.h"

namespace racebeam {

/// Signed 2.24 modulo 2^32.
constexpr vec3 voxel_sum(const vec3& a, const vec3& b) {
  vec3 sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum[axis] =
        static_cast<int>(static_cast<std::uint32_t>(a[axis]) + static_cast<std::uint32_t>(b[axis]));
  return sum;
}

/// 2.24 as 2.16.
constexpr vec3 voxel_direction(const vec3& d24) {
  constexpr int Fraction = 24;
  vec3 direction{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    direction[axis] =
        wrap_signed(d24[axis] >> (Fraction - VoxelDirectionFraction), VoxelDirectionBits);
  return direction;
}

struct voxel_camera_core {
  vec3 line_q{}, pixel_q{};

  struct inputs {
    vec3 d00, dx, dy;
    bool start, next_pixel, next_line;
  };

  vec3 direction() const { return voxel_direction(pixel_q); }
  void clock(const inputs& in) {
    if (in.start) line_q = pixel_q = in.d00;
    else if (in.next_line) line_q = pixel_q = voxel_sum(line_q, in.dy);
    else if (in.next_pixel) pixel_q = voxel_sum(pixel_q, in.dx);
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    static constexpr const char* names[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      visit(std::string("line_") + names[axis] + "_q", VoxelCameraBits,
            [this, axis] { return line_q[axis]; });
      visit(std::string("pixel_") + names[axis] + "_q", VoxelCameraBits,
            [this, axis] { return pixel_q[axis]; });
    }
  }
};

}  // namespace racebeam
