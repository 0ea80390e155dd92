// What a run shows: the chip's own demo, or a scene file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/golden/golden_camera.h"
#include "tb/golden/golden_world.h"
#include "tb/scene/any_scene.h"
#include "tb/scene/beam_scene.h"

namespace racebeam {

class Show {
 public:
  /// The built-in demo.
  Show();
  /// A scene without faults. `hash` tells it from others of the same name.
  Show(std::shared_ptr<const AnyScene> scene, std::string hash);
  Show(SceneFile scene, std::string hash);

  /// What an engine has built in: of beam the demo; of another one 120 pictures.
  static Show built_in(const racebeam::engine& of);
  /// A chip of its own, of which nothing is known but its name.
  static Show of_tile(std::string name, std::string hash, int frames);

  /// What kind of chip shows it.
  const racebeam::engine& engine() const { return *engine_; }
  const std::string& name() const { return name_; }
  /// What it was made of, for the manifest: "built-in", or a checksum of the file.
  const std::string& hash() const { return hash_; }
  /// Frames, or pictures, 0..frames() - 1, then it starts again.
  int frames() const { return frames_; }
  /// The tables for the chip; nullptr: the built-in demo. They live as long as some copy of this.
  const scene_tables* tables() const { return scene_ ? &scene_->tables() : nullptr; }
  /// The knobs of the chip as it was built, with what the scene asks for.
  knob_values standard_knobs() const { return engine().standard(tables()); }
  /// Knobs that the show cannot be run with: what is wrong and what to do; empty if nothing.
  std::string objection(const knob_values& k) const { return engine().objection(k, tables()); }
  /// What is shown in a frame, in a few words; of a chip of its own nothing.
  std::string part(int frame) const;

  /// Whether it is of box rooms: then the following says what of.
  bool of_rooms() const { return beam_ || is_demo(); }
  /// The same tables; nullptr: the built-in demo.
  const scene_program* program() const { return beam_ ? &beam_->program : nullptr; }
  /// What the tables were made from, and its camera's way; nullptr: the built-in demo.
  const SceneFile* scene() const { return beam_ ? &beam_->file : nullptr; }
  const CameraPath* path() const { return beam_ ? &beam_->path : nullptr; }
  GoldenWorld golden_world(int frame, const knobs& k) const;
  GoldenCamera golden_camera(int frame, const knobs& k) const;

 private:
  bool is_demo() const;

  const racebeam::engine* engine_;
  std::string name_, hash_;
  int frames_;
  bool tile_ = false;
  std::shared_ptr<const AnyScene> scene_;  // nullptr: the built-in demo
  const BeamScene* beam_ = nullptr;        // the same, if it is one
};

}  // namespace racebeam
