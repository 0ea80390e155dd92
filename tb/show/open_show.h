// Scenes named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/show/show.h"

namespace racebeam {

/// The project's scenes by name, "house" or "chip/tunnel": files in its folder scenes.
std::vector<std::string> scene_names();

/// The file of a scene: the one of that path, or else the project's of that name or path, such as
/// scenes/house.toml. If there is neither, `scene` itself.
std::string scene_path(const std::string& scene);

/// Reads the scene_path() of `file`, a scene of any kind. Throws UsageError after all its faults
/// are on stderr, or naming the nearest file. `warnings` gets the text of those that there are.
std::shared_ptr<const AnyScene> load_any_scene(const std::string& file,
                                               std::string* warnings = nullptr);
/// The same of one of box rooms; another kind is refused. `what` needs it: "scene plan".
SceneFile load_scene(const std::string& file, const std::string& what);

/// "demo": the built-in demo; else a scene file, found by scene_path(). Throws UsageError as
/// load_any_scene does.
Show open_show(const std::string& scene);

/// A scene as another engine shows it; nullopt if it cannot, with the first reason in `why`.
/// "demo": what the first engine has built in. Throws UsageError if there is no such file.
std::optional<Show> open_show_for(const engine& shown, const std::string& scene, std::string& why);

/// Throws UsageError if a show is not of box rooms, which `what` needs: "--golden".
void expect_rooms(const Show& show, const std::string& what);

/// Throws UsageError, which names the nearest one.
const engine& engine_named(const std::string& name);

/// Throws UsageError if a show is for another engine than that of this name, or there is none; an
/// empty name is any.
void expect_engine(const Show& show, const std::string& engine);

}  // namespace racebeam
