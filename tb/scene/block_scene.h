// BlockScene: a scene of spheres for the block renderer, and what its host gets of it.
//
// The units of a file are the sphere tracer's: x right, y down, z away. `scale` maps them to the
// renderer's: x' = s x, y' = -s y, z' = s (z - screen z). So a file with an eye, a light and
// spheres is one for both.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/host/block_program.h"
#include "tb/scene/any_scene.h"
#include "tb/scene/scene_kinds.h"

namespace racebeam {

class BlockScene final : public AnyScene {
 public:
  const racebeam::engine& engine() const override;
  const std::string& name() const override { return name_; }
  int frames() const override { return pictures_; }
  const BlockProgram& tables() const override { return program_; }
  /// "40 spheres".
  std::string part(int) const override { return counts(); }
  std::string counts() const override;
  std::vector<SceneFact> facts() const override;

 private:
  friend std::shared_ptr<const AnyScene> read_block_scene(const SceneText& file, Faults& faults);

  std::string name_;
  int pictures_ = 120;
  BlockProgram program_;
};

/// All keys of its files, in the order of docs/block.md.
const std::vector<FileKey>& block_scene_keys();

/// SceneKind::read.
std::shared_ptr<const AnyScene> read_block_scene(const SceneText& file, Faults& faults);

}  // namespace racebeam
