// VoxelScene: a scene of the voxel tracer: a world, its colours, a camera's way over it, and
// craters.
//
// x right, y away, z up. A file of another engine is one too, if it has rooms of one storey or
// spheres: voxel_other_scene.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/host/voxel_program.h"
#include "tb/scene/any_scene.h"
#include "tb/scene/scene_kinds.h"

namespace racebeam {

class VoxelScene final : public AnyScene {
 public:
  const racebeam::engine& engine() const override;
  const std::string& name() const override { return name_; }
  int frames() const override { return static_cast<int>(program_.views.size()); }
  const VoxelProgram& tables() const override { return program_; }
  /// The shot's name, or "hills".
  std::string part(int picture) const override;
  std::string counts() const override;
  std::vector<SceneFact> facts() const override;

 private:
  friend std::shared_ptr<const AnyScene> read_voxel_scene(const SceneText& file, Faults& faults);

  std::string name_, what_;
  std::vector<std::string> parts_;  // of each picture
  VoxelProgram program_;
};

/// All keys of its files, in the order of docs/voxel.md.
const std::vector<FileKey>& voxel_scene_keys();

/// SceneKind::read.
std::shared_ptr<const AnyScene> read_voxel_scene(const SceneText& file, Faults& faults);

}  // namespace racebeam
