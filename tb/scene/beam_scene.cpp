// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/beam_scene.h"

#include <utility>

#include "sc/beam/engine.h"
#include "tb/scene/scene_compiler.h"
#include "tb/scene/scene_reader.h"

namespace racebeam {

BeamScene::BeamScene(SceneFile scene)
    : file(std::move(scene)), path(fly(file)), program(compile_scene(file)) {}

const racebeam::engine& BeamScene::engine() const { return beam_engine(); }

std::string BeamScene::part(int frame) const {
  const Shot& shot = file.shot_at(frame);
  if (!shot.name.empty()) return shot.name;
  return "shot " + std::to_string(&shot - file.shots.data());
}

std::string BeamScene::counts() const {
  return std::to_string(file.rooms.size()) + " rooms, " + std::to_string(count_portals(file)) +
         " portals";
}

std::shared_ptr<const AnyScene> read_beam_scene(const SceneText& file, Faults& faults) {
  SceneFile scene = read_scene_tree(file.root, file.text, file.name, faults);
  if (!faults.none()) return nullptr;
  return std::make_shared<BeamScene>(std::move(scene));
}

}  // namespace racebeam
