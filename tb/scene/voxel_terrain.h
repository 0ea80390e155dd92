// Where the ground of a voxel world comes from: functions, and grey pictures. What they make are
// columns as column_memory has them, y * size x + x.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/fixed_point.h"
#include "tb/picture/grey_picture.h"

namespace racebeam {

/// What columns are made of, by what it looks like without a [[material]].
enum VoxelMaterial {
  Meadow = 0,
  Sand = 1,
  Forest = 2,
  Rock = 3,
  Snow = 4,
  Wood = 5,
  Roof = 6,
  Brick = 7
};
constexpr int VoxelMaterials = 8;

/// The highest that something solid may end: heights have 8 bits.
constexpr int voxel_top(const vec3& size) { return size[2] < 255 ? size[2] : 255; }

/// Of ground without materials of its own, by its height.
int ground_material(int height, const vec3& size);

/// The world of the tracer's vectors, in any size: steps, and a post at (20, 30).
std::vector<std::uint32_t> tiny_terrain(const vec3& size);

struct HillsTerrain {
  int seed = 1;
  int octaves = 5;
  int posts = 900;  ///< columns for each post; 0: none
  bool caves = true;
};
/// Noise, squared: wide valleys. Where the ground is low, roofs lie over caves; posts stand
/// anywhere. Its heights go with the world's.
std::vector<std::uint32_t> hills_terrain(const vec3& size, const HillsTerrain& how);

struct CanyonTerrain {
  int seed = 1;
  int offset = 0;  ///< of both cliffs to the right
};
/// A plain with a canyon from one quarter of x to three quarters: both cliffs stand on sides of
/// large voxels, but for the offset, and are rough by up to two columns.
std::vector<std::uint32_t> canyon_terrain(const vec3& size, const CanyonTerrain& how);

/// Columns of pictures that are as large as the world; their top row is the farthest. `middle` and
/// `high`: a second layer, both or none; where `high` is black, there is none. White is the top of
/// the world; of `materials`, the upper three bits count.
struct PictureTerrain {
  const GreyPicture* low = nullptr;
  const GreyPicture* middle = nullptr;
  const GreyPicture* high = nullptr;
  const GreyPicture* materials = nullptr;
};
/// Heights as the pictures have them: low <= middle <= high must be checked.
std::vector<std::uint32_t> picture_terrain(const vec3& size, const PictureTerrain& pictures);

}  // namespace racebeam
