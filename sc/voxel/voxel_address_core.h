// Behaviour of voxel_address (voxel_address.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/voxel_levels.h"

namespace racebeam {

struct voxel_address_core {
  explicit voxel_address_core(const voxel_knobs& k) : levels(k) {}

  const voxel_levels levels;

  voxel_place comb(int x, int y, int z, int level) const {
    return levels.place(level < levels.count() ? level : 0, x, y, z);
  }
};

}  // namespace racebeam
