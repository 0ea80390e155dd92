// Behaviour of voxel_limits (voxel_limits.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/codes.h"

namespace racebeam {

struct voxel_limits_core {
  int outer_q = 0, inner_q = 0;

  struct inputs {
    bool start, outer, inner;
    int max_outer, max_inner;
  };

  bool reached(const inputs& in) const {
    return (in.outer && outer_q == 0) || (in.inner && inner_q <= 1);
  }
  void clock(const inputs& in) {
    if (in.start) {
      outer_q = in.max_outer;
      inner_q = in.max_inner;
      return;
    }
    if (in.outer && outer_q > 0) --outer_q;
    if (in.inner && inner_q > 0) --inner_q;
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("outer_q", VoxelLimitBits, [this] { return outer_q; });
    visit("inner_q", VoxelLimitBits, [this] { return inner_q; });
  }
};

}  // namespace racebeam
