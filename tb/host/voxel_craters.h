// How the host digs craters: it changes columns, and what it has changed is built anew.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/voxel/voxel_world.h"
#include "tb/host/voxel_program.h"

namespace racebeam {

/// Units that a crater takes off a column that is (x, y) from its middle: a bowl, `depth` in the
/// middle and nothing from the radius on.
int dug(const VoxelCrater& crater, int x, int y);

/// Digs from above: what lies from middle to high goes first, what is left goes off low. The world
/// repeats. Returns what has changed, cut where the world ends: up to four rectangles.
std::vector<voxel_rectangle> make_crater(const VoxelCrater& crater, const vec3& size,
                                         std::vector<std::uint32_t>& columns);

}  // namespace racebeam
