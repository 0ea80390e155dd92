// What a run shows: the chip's own demo, or a scene file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "sc/base/engine.h"
#include "sc/beam/scene_program.h"
#include "tb/golden/golden_camera.h"
#include "tb/golden/golden_world.h"
#include "tb/scene/camera_path.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

class Show {
 public:
  /// The built-in demo.
  Show();
  /// A scene without faults. `hash` tells it from others of the same name.
  Show(SceneFile scene, std::string hash);

  /// A chip of its own, of which nothing is known but its name.
  static Show of_tile(std::string name, std::string hash, int frames);

  /// What kind of chip shows it.
  const racebeam::engine& engine() const { return *engine_; }
  const std::string& name() const { return name_; }
  /// What it was made of, for the manifest: "built-in", or a checksum of the file.
  const std::string& hash() const { return hash_; }
  /// Frames 0..frames() - 1, then it starts again.
  int frames() const { return frames_; }
  /// The tables for any chip; nullptr: the built-in demo. They live as long as some copy of this.
  const scene_tables* tables() const { return program_.get(); }
  /// The same for the chip of beam; nullptr: the built-in demo. They live as long as some copy of
  /// this.
  const scene_program* program() const { return program_.get(); }
  /// What the tables were made from, and its camera's way; nullptr: the built-in demo.
  const SceneFile* scene() const { return scene_.get(); }
  const CameraPath* path() const { return path_.get(); }
  /// The knobs of the taped-out chip, with the widths that the scene asks for.
  knobs standard_knobs() const;
  /// Knobs that the show cannot be run with: what is wrong and what to do; empty if nothing.
  std::string objection(const knobs& k) const;
  /// What is shown in a frame, in a few words; of a chip of its own nothing.
  std::string part(int frame) const;

  GoldenWorld golden_world(int frame, const knobs& k) const;
  GoldenCamera golden_camera(int frame, const knobs& k) const;

 private:
  const racebeam::engine* engine_;
  std::string name_, hash_;
  int frames_;
  bool tile_ = false;
  std::shared_ptr<const SceneFile> scene_;
  std::shared_ptr<const CameraPath> path_;
  std::shared_ptr<const scene_program> program_;
};

}  // namespace racebeam
