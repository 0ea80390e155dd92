// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/show.h"

#include <utility>

#include "sc/base/constants.h"
#include "tb/scene/scene_compiler.h"
#include "tb/show/demo_parts.h"

namespace racebeam {

Show::Show() : engine_(engines().front()), name_("demo"), hash_("built-in"), frames_(DemoFrames) {}

Show::Show(SceneFile scene, std::string hash)
    : engine_(scene.engine),
      name_(scene.name),
      hash_(std::move(hash)),
      frames_(scene.frames),
      scene_(std::make_shared<SceneFile>(std::move(scene))),
      path_(std::make_shared<CameraPath>(fly(*scene_))),
      program_(std::make_shared<scene_program>(compile_scene(*scene_))) {}

Show Show::of_tile(std::string name, std::string hash, int frames) {
  Show show;
  show.name_ = std::move(name);
  show.hash_ = std::move(hash);
  show.frames_ = frames;
  show.tile_ = true;
  return show;
}

knobs Show::standard_knobs() const { return program_ ? program_->fitted({}) : knobs{}; }

std::string Show::objection(const knobs& k) const {
  if (!program_ && k.corner_bits > CornerBits)
    return "corner_bits is at most " + std::to_string(CornerBits) +
           " in the built-in demo, whose rooms count modulo 4096; render a scene file for more";
  return "";
}

std::string Show::part(int frame) const {
  if (tile_) return "";
  if (!scene_) return demo_part(frame).name();
  const Shot& shot = scene_->shot_at(frame);
  if (!shot.name.empty()) return shot.name;
  return "shot " + std::to_string(&shot - scene_->shots.data());
}

GoldenWorld Show::golden_world(int frame, const knobs& k) const {
  return scene_ ? GoldenWorld(*scene_, *path_, frame, k) : GoldenWorld(frame, k);
}

GoldenCamera Show::golden_camera(int frame, const knobs& k) const {
  return scene_ ? GoldenCamera(*scene_, frame, k) : GoldenCamera(frame, k);
}

}  // namespace racebeam
