// Scenes named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/show.h"

namespace racebeam {

/// Reads a scene file. Throws UsageError after all its faults are on stderr.
SceneFile load_scene(const std::string& file);

/// "demo": the built-in demo; else a scene file. Throws UsageError as load_scene does, or naming
/// the nearest file.
Show open_show(const std::string& scene);

}  // namespace racebeam
