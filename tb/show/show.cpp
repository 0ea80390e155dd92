// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/show.h"

#include <utility>

#include "sc/base/constants.h"
#include "tb/scene/engines.h"
#include "tb/show/demo_parts.h"

namespace racebeam {

Show::Show() : engine_(engines().front()), name_("demo"), hash_("built-in"), frames_(DemoFrames) {}

Show::Show(std::shared_ptr<const AnyScene> scene, std::string hash)
    : engine_(&scene->engine()),
      name_(scene->name()),
      hash_(std::move(hash)),
      frames_(scene->frames()),
      scene_(std::move(scene)),
      beam_(dynamic_cast<const BeamScene*>(scene_.get())) {}

Show::Show(SceneFile scene, std::string hash)
    : Show(std::make_shared<BeamScene>(std::move(scene)), std::move(hash)) {}

Show Show::built_in(const racebeam::engine& of) {
  Show show;
  if (show.engine_ == &of) return show;
  show.engine_ = &of;
  show.frames_ = 120;
  return show;
}

bool Show::is_demo() const { return !scene_ && engine_ == engines().front(); }

Show Show::of_tile(std::string name, std::string hash, int frames) {
  Show show;
  show.name_ = std::move(name);
  show.hash_ = std::move(hash);
  show.frames_ = frames;
  show.tile_ = true;
  return show;
}

std::string Show::part(int frame) const {
  if (tile_) return "";
  return scene_ ? scene_->part(frame) : is_demo() ? demo_part(frame).name() : "";
}

GoldenWorld Show::golden_world(int frame, const knobs& k) const {
  return beam_ ? GoldenWorld(beam_->file, beam_->path, frame, k) : GoldenWorld(frame, k);
}

GoldenCamera Show::golden_camera(int frame, const knobs& k) const {
  return beam_ ? GoldenCamera(beam_->file, frame, k) : GoldenCamera(frame, k);
}

}  // namespace racebeam
