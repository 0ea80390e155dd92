// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/camera_path.h"

#include <algorithm>
#include <cstdlib>

namespace racebeam {

namespace {

// The chip's range: at the high face it is still inside, at the low one already beyond.
bool inside(const Room& room, const Vector& position) {
  for (int axis = 0; axis < 3; ++axis)
    if (position[axis] > room.half_size[axis] || position[axis] <= -room.half_size[axis])
      return false;
  return true;
}

// The face it is beyond: the positive ones first, by axis, as the navigator tests them.
int face_left(const Room& room, const Vector& position) {
  for (int axis = 0; axis < 3; ++axis)
    if (position[axis] > room.half_size[axis]) return 2 * axis;
  for (int axis = 0; axis < 3; ++axis)
    if (position[axis] <= -room.half_size[axis]) return 2 * axis + 1;
  return -1;
}

// As the chip's corner adder holds it, where portals may lead anywhere.
int wrapped(int value, int bits) {
  const int range = 1 << bits;
  return ((value + range / 2) % range + range) % range - range / 2;
}

Vector seen_from(const SceneFile& scene, const Room& to, const Room& from, const Vector& position) {
  Vector result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = position[axis] + from.centre[axis] - to.centre[axis];
    if (scene.overlap && scene.corner_bits > 0)
      result[axis] = wrapped(result[axis], scene.corner_bits);
  }
  return result;
}

void measure(const SceneFile& scene, const PathPoint& point, CameraPath& path) {
  for (int axis = 0; axis < 3; ++axis) {
    const int distance = std::abs(point.position[axis]);
    path.largest = std::max(path.largest, distance);
    const int reach = distance + scene.rooms[point.room].half_size[axis];
    if (reach <= path.reach) continue;
    path.reach = reach;
    path.reach_room = point.room;
  }
}

}  // namespace

bool cross_portal(const SceneFile& scene, int face, PathPoint& point) {
  const Room& from = scene.rooms[point.room];
  for (const int number : from.portals[face]) {
    const Room& to = scene.rooms[number];
    const Vector position = seen_from(scene, to, from, point.position);
    if (!inside(to, position)) continue;
    point = {number, position};
    return true;
  }
  return false;
}

CameraPath fly(const SceneFile& scene) {
  CameraPath path;
  PathPoint point;
  bool flying = false;  // from the second frame of a flight on
  for (std::size_t i = 0; i < scene.shots.size(); ++i) {
    const Shot& shot = scene.shots[i];
    const int end = i + 1 < scene.shots.size() ? scene.shots[i + 1].frame : scene.frames;
    for (int frame = shot.frame; frame < std::min(end, scene.frames); ++frame) {
      if (shot.restart && frame == shot.frame) {
        point = {shot.camera.room, shot.camera.position};
        flying = false;
      }
      const int face = face_left(scene.rooms[point.room], point.position);
      if (face >= 0 && !cross_portal(scene, face, point)) {
        path.end = PathEnd{frame, point.room, face};
        return path;
      }
      if (face >= 0) ++path.crossings[face];
      path.points.push_back(point);
      measure(scene, point, path);
      if (flying)
        for (int axis = 0; axis < 3; ++axis) point.position[axis] += shot.camera.velocity[axis];
      flying = true;
      measure(scene, point, path);
    }
  }
  return path;
}

}  // namespace racebeam
