// Reads a scene file: all that is good in it, and all its faults at once.
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

/// Reads and checks a scene from its text. `name` is the scene's name if the text gives none.
SceneResult read_scene(std::string_view text, const std::string& name);

/// The same from a file; a file that cannot be read is a fault too.
SceneResult read_scene_file(const std::string& path);

}  // namespace racebeam
