// The camera, the look and the timeline of a scene file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "tb/scene/scene_file.h"
#include "tb/scene/toml_tree.h"

namespace racebeam {

/// Why there are at most MaxFrames.
inline constexpr const char* FrameBitsHelp = "the chip's frame counter has 14 bits";

/// Fills scene.shots from [camera], [look] and [[shot]], which `root` holds. The rooms, by name,
/// and `scene.frames` (0: not given, then it is set) are there before.
void read_shots(const TomlNode& root, const std::map<std::string, int>& numbers, SceneFile& scene,
                Faults& faults);

}  // namespace racebeam
