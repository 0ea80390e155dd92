// The camera's way through the rooms, frame by frame, as the chip flies it.
//
// Once per frame, after it is shown, the camera moves by its velocity; if it then is beyond a face
// it changes into the room behind it: one room per frame. The first two frames of a flight show
// the same position, as on the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tb/scene/scene_file.h"

namespace racebeam {

struct PathPoint {
  int room = 0;
  Vector position{};  ///< from the centre of that room
};

/// Where the camera would leave the rooms.
struct PathEnd {
  int frame = 0;  ///< that cannot be shown
  int room = 0;   ///< the last one
  int face = 0;   ///< of it, through which it leaves
};

struct CameraPath {
  std::vector<PathPoint> points;  ///< one for each frame; fewer if it ends early
  std::optional<PathEnd> end;     ///< it meets a wall
  int largest = 0;                ///< distance from a room's centre along any axis
  /// The most that the chip's adder holds on the way: that distance and the room's half size.
  int reach = 0;
  int reach_room = 0;                      ///< the room of it
  std::array<int, FaceCount> crossings{};  ///< portals passed, by the face left through
};

/// Moves a point that has left its room by `face` into the room behind it that holds it; false,
/// and unchanged, if there is none.
bool cross_portal(const SceneFile& scene, int face, PathPoint& point);

/// Flies scene.frames frames. The scene has rooms and shots.
CameraPath fly(const SceneFile& scene);

}  // namespace racebeam
