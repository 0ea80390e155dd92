// Behaviour of voxel_setup (voxel_setup.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/voxel/numbers.h"

namespace racebeam {

struct voxel_setup_core {
  static constexpr int Clocks = VoxelInverseBits / 2;

  int step_q = 0;  // clocks that are over; 0: it waits
  std::array<std::uint32_t, 3> remainder_q{}, inverse_q{};

  struct inputs {
    bool rst_n, start;
    vec3 direction;
  };

  static int parallel(const vec3& direction) {
    int bits = 0;
    for (int axis = 0; axis < 3; ++axis) bits |= voxel_parallel(direction[axis]) << axis;
    return bits;
  }
  bool done() const { return step_q == Clocks - 1; }
  std::uint32_t inverse(int axis, const vec3& direction) const {
    return voxel_parallel(direction[axis]) ? 0 : inverse_q[static_cast<std::size_t>(axis)];
  }

  void clock(const inputs& in) {
    const bool works = step_q > 0 || in.start;
    for (std::size_t axis = 0; works && axis < 3; ++axis) {
      const int d = in.direction[axis];
      const auto divisor = static_cast<std::uint32_t>(d < 0 ? -d : d);
      // The digits above the quotient's are all that there is of 2^36.
      if (step_q == 0) remainder_q[axis] = std::uint32_t{1} << (36 - VoxelInverseBits);
      for (int digit = 0; digit < 2; ++digit) {
        const std::uint32_t rest = remainder_q[axis] << 1;
        const bool one = rest >= divisor;
        remainder_q[axis] = (one ? rest - divisor : rest) & low_bits(VoxelDirectionBits);
        inverse_q[axis] = inverse_q[axis] << 1 | one;
      }
    }
    step_q = in.rst_n && works ? (step_q + 1) % Clocks : 0;
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    static constexpr const char* names[] = {"x", "y", "z"};
    visit("step_q", 4, [this] { return step_q; });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      visit(std::string("remainder_") + names[axis] + "_q", VoxelDirectionBits,
            [this, axis] { return remainder_q[axis]; });
      visit(std::string("inverse_") + names[axis] + "_q", VoxelInverseBits,
            [this, axis] { return inverse_q[axis]; });
    }
  }
};

}  // namespace racebeam
