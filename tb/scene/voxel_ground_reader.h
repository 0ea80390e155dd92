// The table [terrain] of a voxel scene: the world's size, and its columns from what it names.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/host/voxel_pinhole.h"
#include "tb/scene/voxel_other_scene.h"
#include "tb/scene/voxel_palette.h"

namespace racebeam {

struct VoxelGround {
  vec3 size{512, 512, 128}, voxel{1, 4, 1};
  std::string what;                    ///< it is made from: "hills"
  std::vector<std::uint32_t> columns;  ///< none if there are faults
  std::vector<int> objects;            ///< VoxelProgram::objects
  VoxelColours colours = landscape_colours();
  Place place{1, 1};  ///< of what it is made from
  // What a scene of another engine has, if it is made from one.
  std::vector<VoxelPinhole> pinholes;  ///< by picture; then again
  std::optional<int> pictures;
  std::optional<std::array<int, 2>> shown;  ///< size of the picture
};

VoxelGround read_voxel_ground(const VoxelFile& split, const SceneText& file, Faults& faults);

}  // namespace racebeam
