// BeamScene: a scene of box rooms, its camera's way, and the tables of the interval tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "sc/beam/scene_program.h"
#include "tb/scene/any_scene.h"
#include "tb/scene/camera_path.h"
#include "tb/scene/scene_file.h"
#include "tb/scene/scene_kinds.h"

namespace racebeam {

class BeamScene final : public AnyScene {
 public:
  /// A scene without faults.
  explicit BeamScene(SceneFile scene);

  const racebeam::engine& engine() const override;
  const std::string& name() const override { return file.name; }
  int frames() const override { return file.frames; }
  const scene_tables& tables() const override { return program; }
  std::string part(int frame) const override;
  std::string counts() const override;

  const SceneFile file;
  const CameraPath path;
  const scene_program program;
};

/// SceneKind::read.
std::shared_ptr<const AnyScene> read_beam_scene(const SceneText& file, Faults& faults);

}  // namespace racebeam
