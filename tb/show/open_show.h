// Scenes named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/show.h"

namespace racebeam {

/// The project's scenes by name, "house" or "chip/tunnel": files in its folder scenes.
std::vector<std::string> scene_names();

/// The file of a scene: the one of that path, or else the project's of that name or path, such as
/// scenes/house.toml. If there is neither, `scene` itself.
std::string scene_path(const std::string& scene);

/// Reads the scene_path() of `file`. Throws UsageError after all its faults are on stderr, or
/// naming the nearest file. `warnings` gets the text of those that there are.
SceneFile load_scene(const std::string& file, std::string* warnings = nullptr);

/// "demo": the built-in demo; else a scene file, found by scene_path(). Throws UsageError as
/// load_scene does.
Show open_show(const std::string& scene);

}  // namespace racebeam
