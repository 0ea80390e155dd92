// The scenes that `racebeam scene new` writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// A scene file without faults, to start from: of box rooms, of spheres.
const char* starter_scene();
const char* starter_sphere_scene();
const char* starter_block_scene();
const char* starter_voxel_scene();

}  // namespace racebeam
