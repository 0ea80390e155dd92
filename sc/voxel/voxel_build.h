// voxel_build: what voxel_builder makes of a world's columns, and how long it takes, as plain loops
// over tiles.
//
// A rectangle of columns is aligned outwards to voxels. CLEAR: no bit of level 0 in it is set.
// Then, and not before, as columns share voxels, FILL: each column sets the bits of voxels in which
// it has something solid. UP, level by level: a voxel is occupied if one of its eight children is.
//
// Source: article "Preparation".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/voxel/voxel_world.h"

namespace racebeam {

/// What a build cost.
struct voxel_built {
  std::uint64_t clear = 0, fill = 0, up = 0;  ///< clocks of each part
  std::uint64_t clocks = 0;                   ///< of all three
  std::uint64_t columns = 0;                  ///< of the rectangle, aligned
};

/// The rectangle in the voxels of a level, aligned outwards.
voxel_rectangle voxel_aligned(const voxel_rectangle& columns, const voxel_levels& levels,
                              int level);

/// Whether there is something to be built, all of it in the world.
constexpr bool voxel_buildable(const voxel_rectangle& r, const vec3& size) {
  return r.x_low >= 0 && r.y_low >= 0 && r.x_low < r.x_high && r.y_low < r.y_high &&
         r.x_high <= size[0] && r.y_high <= size[1];
}
/// Throws std::invalid_argument, saying why, if it is not.
void expect_buildable(const voxel_rectangle& r, const vec3& size);

/// Builds the rectangle; `memory_clocks`: the knob. Throws std::invalid_argument if it is not
/// buildable.
voxel_built voxel_build(voxel_world& world, const voxel_rectangle& columns, int memory_clocks = 1);
/// Builds all.
voxel_built voxel_build(voxel_world& world, int memory_clocks = 1);

/// The parts; each returns its clocks.
std::uint64_t voxel_clear(voxel_world& world, const voxel_rectangle& columns,
                          int memory_clocks = 1);
std::uint64_t voxel_fill(voxel_world& world, const voxel_rectangle& columns, int memory_clocks = 1);
std::uint64_t voxel_up(voxel_world& world, const voxel_rectangle& columns, int memory_clocks = 1);

}  // namespace racebeam
