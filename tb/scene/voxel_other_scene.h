// Scenes of other engines that a voxel world is made from: files that a scene names, and a file of
// another engine that the voxel tracer shows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/scene/beam_scene.h"
#include "tb/scene/sphere_scene.h"

namespace racebeam {

/// What a file is to the voxel tracer.
struct VoxelFile {
  TomlNode own;                            ///< its keys for the voxel tracer
  std::optional<TomlNode> rooms, spheres;  ///< the same file as what it is to its own engine
};

/// A file of beam or sphere: what voxel has of it stands in [for.voxel]; other keys are those of
/// its engine. Faults if it is another engine's. `root` of `file` is not looked at.
VoxelFile split_voxel_file(const SceneText& file, Faults& faults);

/// A scene of rooms, or of spheres.
struct VoxelOther {
  std::shared_ptr<const BeamScene> rooms;
  std::shared_ptr<const SphereScene> spheres;
  std::vector<std::string> names;  ///< of the spheres

  bool any() const { return rooms || spheres; }
};

/// Of a file that is one to its own engine.
VoxelOther read_own_scene(const VoxelFile& split, const SceneText& file, Faults& faults);
/// Of the file that `named` names, beside `file`. The fault of one that has faults is at `named`.
VoxelOther read_named_rooms(const TomlNode& named, const SceneText& file, Faults& faults);
VoxelOther read_named_spheres(const TomlNode& named, const SceneText& file, Faults& faults);

/// Where a file that a scene names lies.
std::string beside(const SceneText& file, const std::string& name);

}  // namespace racebeam
