// The kinds of scene files, one for each engine, in one table: the key `engine` of a file chooses.
// Readers share the tree of the file, faults with places and help, and TableReader.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/any_scene.h"
#include "tb/scene/faults.h"
#include "tb/scene/scene_keys.h"
#include "tb/scene/toml_tree.h"

namespace racebeam {

/// A scene file that is TOML.
struct SceneText {
  const TomlNode& root;
  std::string_view text;
  std::string name;         ///< the scene's if the file gives none
  std::string folder = "";  ///< where it lies: files that it names lie there
};

struct SceneKind {
  const racebeam::engine& engine;
  const std::vector<FileKey>& keys;  ///< what its reader accepts
  /// nullptr if there are faults, which it adds.
  std::shared_ptr<const AnyScene> (*read)(const SceneText& file, Faults& faults);
  /// A scene without faults, to start from; nullptr: there is none.
  const char* (*starter)() = nullptr;
};

/// By engine; a file without the key is of the first.
const std::vector<SceneKind>& scene_kinds();

/// The kind of an engine. Throws std::out_of_range.
const SceneKind& scene_kind_of(const engine& shown);

struct AnySceneResult {
  std::shared_ptr<const AnyScene> scene;  ///< nullptr if there are faults
  Faults faults;
  std::string text{};  ///< of a file that could be read
};

/// Reads and checks a scene of any kind from its text; `shown` as below, `folder` as of SceneText.
AnySceneResult read_any_scene(std::string_view text, const std::string& name,
                              const std::vector<SceneKind>& kinds = scene_kinds(),
                              const engine* shown = nullptr, const std::string& folder = "");

/// The same from a file; a file that cannot be read is a fault too. `shown`: what shows it,
/// whatever engine the file names; with the tables in [for.ENGINE], which are read as if they stood
/// at the top.
AnySceneResult read_any_scene_file(const std::string& path, const engine* shown = nullptr);

}  // namespace racebeam
