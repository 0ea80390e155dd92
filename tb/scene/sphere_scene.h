// SphereScene: a scene of spheres and planes, its point light, and what the sphere tracer and the
// CPU beside it get of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/host/sphere_program.h"
#include "tb/scene/any_scene.h"
#include "tb/scene/scene_kinds.h"

namespace racebeam {

class SphereScene final : public AnyScene {
 public:
  const racebeam::engine& engine() const override;
  const std::string& name() const override { return name_; }
  int frames() const override { return pictures_; }
  const SphereProgram& tables() const override { return program_; }
  /// "8x, 3 reflections, planes", or "plain".
  std::string part(int picture) const override;
  std::string counts() const override;
  std::vector<SceneFact> facts() const override;

 private:
  friend std::shared_ptr<const AnyScene> read_sphere_scene(const SceneText& file, Faults& faults);

  std::string name_;
  int pictures_ = 120;
  SphereProgram program_;
};

/// All keys of its files, in the order of docs/sphere.md.
const std::vector<FileKey>& sphere_scene_keys();

/// SceneKind::read.
std::shared_ptr<const AnyScene> read_sphere_scene(const SceneText& file, Faults& faults);

}  // namespace racebeam
