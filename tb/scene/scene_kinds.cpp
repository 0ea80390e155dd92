// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_kinds.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/scene/beam_scene.h"
#include "tb/scene/block_scene.h"
#include "tb/scene/input_file.h"
#include "tb/scene/sphere_scene.h"
#include "tb/scene/starter_scene.h"
#include "tb/scene/table_reader.h"
#include "tb/scene/voxel_scene.h"

namespace racebeam {

namespace {

/// nullptr, and a fault, if the file names none that there is.
const SceneKind* kind_of(const TomlNode& root, const std::vector<SceneKind>& kinds,
                         Faults& faults) {
  const TomlNode* const named = root.find("engine");
  if (!named) return &kinds.front();
  std::vector<std::string> names;
  for (const SceneKind& kind : kinds) names.emplace_back(kind.engine.name);
  int number = 0;
  return read_word(*named, "engine", names, number, faults) ? &kinds[number] : nullptr;
}

constexpr const char* For = "for";

/// What [for.ENGINE] has goes to the top; what is for other engines goes away.
void take_own_tables(TomlNode& root, const std::string& name, const std::vector<SceneKind>& kinds,
                     Faults& faults) {
  const auto at = std::find_if(root.entries.begin(), root.entries.end(),
                               [](const TomlEntry& entry) { return entry.key == For; });
  if (at == root.entries.end()) return;
  const TomlNode all = std::move(at->value);
  root.entries.erase(at);
  if (all.kind != TomlNode::Table)
    return faults.add(all.place, "'for' is no table", "write [for.block], and its keys below");
  for (const TomlEntry& entry : all.entries) {
    const bool known = std::any_of(kinds.begin(), kinds.end(), [&](const SceneKind& kind) {
      return entry.key == kind.engine.name;
    });
    if (!known || entry.value.kind != TomlNode::Table)
      faults.add(entry.place, "'for' has no table for an engine " + racebeam::quoted(entry.key),
                 "write [for.block], or the name of another engine");
    else if (entry.key == name)
      root.entries.insert(root.entries.end(), entry.value.entries.begin(),
                          entry.value.entries.end());
  }
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> table = {
      {beam_engine(), scene_keys(), read_beam_scene, starter_scene},
      {sphere_engine(), sphere_scene_keys(), read_sphere_scene, starter_sphere_scene},
      {block_engine(), block_scene_keys(), read_block_scene, starter_block_scene},
      {voxel_engine(), voxel_scene_keys(), read_voxel_scene, starter_voxel_scene}};
  return table;
}

const SceneKind& scene_kind_of(const engine& shown) {
  for (const SceneKind& kind : scene_kinds())
    if (&kind.engine == &shown) return kind;
  throw std::out_of_range(std::string("no scenes for ") + shown.name);
}

AnySceneResult read_any_scene(std::string_view text, const std::string& name,
                              const std::vector<SceneKind>& kinds, const engine* shown,
                              const std::string& folder) {
  AnySceneResult result;
  std::optional<TomlNode> root = parse_toml(text, result.faults);
  if (!root) return result;
  const SceneKind* const kind =
      shown ? &scene_kind_of(*shown) : kind_of(*root, kinds, result.faults);
  if (!kind) return result;
  take_own_tables(*root, kind->engine.name, kinds, result.faults);
  if (result.faults.none()) result.scene = kind->read({*root, text, name, folder}, result.faults);
  return result;
}

AnySceneResult read_any_scene_file(const std::string& path, const engine* shown) {
  AnySceneResult result;
  std::optional<std::string> text = read_input_file(path, "scene", result.faults);
  if (!text) return result;
  const std::filesystem::path file(path);
  result = read_any_scene(*text, file.stem().string(), scene_kinds(), shown,
                          file.parent_path().string());
  result.text = std::move(*text);
  return result;
}

}  // namespace racebeam
