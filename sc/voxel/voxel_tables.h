// What the voxel tracer's host knows of a scene before the first picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/fixed_point.h"
#include "sc/voxel/voxel_colour.h"

namespace racebeam {

/// The rays of a picture, as the host's registers hold them.
struct voxel_view {
  vec3 origin{};                    ///< 16.8
  vec3 d00{}, dx{}, dy{};           ///< 2.24
  vec3 light{14301, 28602, 57205};  ///< towards it, 2.16: (1, 2, 4) normalised
};

struct voxel_tables : scene_tables {
  vec3 size{64, 64, 32};               ///< of the world, in units
  vec3 voxel{1, 4, 1};                 ///< the smallest
  int width = 64, height = 48;         ///< of the picture
  std::vector<std::uint32_t> columns;  ///< as column_memory has them, y * size x + x
  voxel_palette palette{};
};

}  // namespace racebeam
