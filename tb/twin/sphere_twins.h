// What makes plug-ins of the units of sphere.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Plug-ins for sphere tracers with the knobs `k` that show a scene. `traced`: signals inside the
/// RTL can be read.
PluginMaker sphere_plugins(const sphere_knobs& k, const sphere_tables& scene, bool traced = false);

}  // namespace racebeam
