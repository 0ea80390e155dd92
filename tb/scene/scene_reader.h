// Reads a scene file of the interval tracer: all that is good in it, and all its faults at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "tb/scene/faults.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

struct SceneResult {
  SceneFile scene;  ///< usable only without faults
  Faults faults;
  std::string text{};  ///< of a file that could be read
};

struct TomlNode;

/// Reads and checks a scene of box rooms from the tree of its text. Usable only without faults.
SceneFile read_scene_tree(const TomlNode& root, std::string_view text, const std::string& name,
                          Faults& faults);

/// The same from its text alone. `name` is the scene's name if the text gives none.
SceneResult read_scene(std::string_view text, const std::string& name);

/// The same from a file; a file that cannot be read is a fault too.
SceneResult read_scene_file(const std::string& path);

}  // namespace racebeam
