// From a scene file to the tables of the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/scene_program.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// The tables of a scene without faults. Rooms keep their numbers, portals their order.
scene_program compile_scene(const SceneFile& scene);

}  // namespace racebeam
