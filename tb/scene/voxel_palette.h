// Colours of a voxel world: of each material at height 0 and at the top, and between them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/voxel/voxel_tables.h"
#include "tb/scene/voxel_terrain.h"

namespace racebeam {

struct MaterialColours {
  std::uint32_t low, high;  ///< 0xrrggbb
};

using VoxelColours = std::array<MaterialColours, VoxelMaterials>;

/// A landscape's, by VoxelMaterial.
const VoxelColours& landscape_colours();

/// As the tracer has them: sixteen heights of each material.
voxel_palette palette_of(const VoxelColours& colours);

}  // namespace racebeam
