// How far one can see: a ray passes portals of at most three directions, one per axis, and at most
// VisibleRooms of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/scene_file.h"

namespace racebeam {

/// The corner in sight that is farthest from the camera, along one axis.
struct FarCorner {
  long long distance = 0;  ///< from the opposite side of the camera's room
  int from = 0, to = 0;    ///< rooms of the camera and of the corner
};

/// The largest number of portals that a straight view passes, at most VisibleRooms.
int deepest_view(const SceneFile& scene);

/// Over all rooms that a camera could be in.
FarCorner farthest_corner(const SceneFile& scene);

}  // namespace racebeam
