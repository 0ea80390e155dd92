// Scenes named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/show/show.h"

namespace racebeam {

/// Reads a scene file. Throws UsageError after all its faults are on stderr, or naming the nearest
/// file. `warnings` gets the text of those that there are.
SceneFile load_scene(const std::string& file, std::string* warnings = nullptr);

/// "demo": the built-in demo; else a scene file. Throws UsageError as load_scene does.
Show open_show(const std::string& scene);

}  // namespace racebeam
