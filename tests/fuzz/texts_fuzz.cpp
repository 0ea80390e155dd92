// libFuzzer target: no text makes the reader of a scene, of whatever engine it says it is, crash or
// hang. It reads and checks, and neither compiles nor flies: the targets scene, spheres and voxel
// do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/scene/beam_scene.h"
#include "tb/scene/block_scene.h"
#include "tb/scene/scene_kinds.h"
#include "tb/scene/scene_reader.h"
#include "tb/scene/scene_sight.h"
#include "tb/scene/sphere_scene.h"
#include "tb/scene/starter_scene.h"
#include "tb/scene/voxel_scene.h"
#include "tests/fuzz/stand_in_engines.h"

namespace racebeam {

// Three quarters of the time went into how far one sees, which no text can break.
int deepest_view(const SceneFile&) { std::abort(); }
FarCorner farthest_corner(const SceneFile&) { return {}; }

namespace {

const std::vector<knob_row> no_knobs;

}  // namespace

const engine& beam_engine() {
  static const engine row = stand_in_engine("beam", no_knobs);
  return row;
}
const engine& sphere_engine() {
  static const engine row = stand_in_engine("sphere", no_knobs);
  return row;
}
const engine& block_engine() {
  static const engine row = stand_in_engine("block", no_knobs);
  return row;
}
const engine& voxel_engine() {
  static const engine row = stand_in_engine("voxel", no_knobs);
  return row;
}

namespace {

/// Without its path and its tables.
std::shared_ptr<const AnyScene> read_rooms(const SceneText& file, Faults& faults) {
  (void)read_scene_tree(file.root, file.text, file.name, faults);
  return nullptr;
}

const std::vector<SceneKind>& kinds() {
  static const std::vector<SceneKind> table = {
      {beam_engine(), scene_keys(), read_rooms},
      {sphere_engine(), sphere_scene_keys(), read_sphere_scene},
      {block_engine(), block_scene_keys(), read_block_scene},
      {voxel_engine(), voxel_scene_keys(), read_voxel_scene}};
  return table;
}

}  // namespace

}  // namespace racebeam

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  const AnySceneResult result = read_any_scene(text_of(data, size), "fuzz", kinds());
  (void)result.faults.text("fuzz");
  (void)result.faults.warnings("fuzz");
  check(result.faults.none() || !result.scene);
  return 0;
}
