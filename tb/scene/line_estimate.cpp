// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/line_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace racebeam {

namespace {

constexpr int Frames = 32;          // looked at
constexpr int Lines = 8;            // every so many lines
constexpr int Pixels = 4;           // every so many pixels
constexpr int RoomClocks = 13;      // six decisions of two clocks, one for the room change
constexpr int IntervalClocks = 10;  // bisection, return

using Direction = std::array<double, 3>;

struct Basis {
  Direction forward, right, down;
};

// What a ray meets: the rooms it passes and the face it ends at.
struct Sighting {
  std::array<int, VisibleRooms + 1> rooms{};
  int count = 0, face = 0;
};

Basis basis(const Camera& camera, int frame, int y) {
  const double unit = 2 * std::acos(-1.0) / TurnUnits;
  const double yaw = unit * camera.yaw.value(frame, y, TurnUnits);
  const double pitch = unit * camera.pitch.value(frame, y, TurnUnits);
  const double sy = std::sin(yaw), cy = std::cos(yaw), sp = std::sin(pitch), cp = std::cos(pitch);
  return {{sy * cp, sp, cy * cp}, {cy, 0, -sy}, {-sy * sp, cp, -cy * sp}};
}

// The room behind a face at a point, or -1.
int room_behind(const SceneFile& scene, const Room& room, int face, const Direction& point) {
  for (const int number : room.portals[face]) {
    const Room& next = scene.rooms[number];
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
      if (axis != face_axis(face))
        within = within && point[axis] >= next.low(axis) && point[axis] <= next.high(axis);
    if (within) return number;
  }
  return -1;
}

Sighting look(const SceneFile& scene, const PathPoint& from, const Direction& ray) {
  Sighting seen;
  Direction origin;
  for (int axis = 0; axis < 3; ++axis)
    origin[axis] = scene.rooms[from.room].centre[axis] + from.position[axis] + 0.25;
  for (int room = from.room; room >= 0 && seen.count <= VisibleRooms;) {
    const Room& box = scene.rooms[room];
    seen.rooms[seen.count++] = room;
    double nearest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (ray[axis] == 0) continue;
      const double side = ray[axis] > 0 ? box.high(axis) : box.low(axis);
      const double distance = (side - origin[axis]) / ray[axis];
      if (distance >= nearest) continue;
      nearest = distance;
      seen.face = 2 * axis + (ray[axis] < 0);
    }
    Direction point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = ray[axis] == 0 ? origin[axis] : origin[axis] + nearest * ray[axis];
    room = room_behind(scene, box, seen.face, point);
  }
  return seen;
}

// Rooms that `now` enters and `before` did not.
int rooms_entered(const Sighting& before, const Sighting& now) {
  int shared = 0;
  while (shared < std::min(before.count, now.count) && before.rooms[shared] == now.rooms[shared])
    ++shared;
  return now.count - shared;
}

LineEstimate estimate_line(const SceneFile& scene, const PathPoint& from, int frame, int y) {
  LineEstimate line;
  line.frame = frame;
  line.y = y;
  const Camera& camera = scene.shot_at(frame).camera;
  const Basis view = basis(camera, frame, y);
  const double focal = camera.fov.value(frame, y, FocalUnits);
  Sighting before;
  for (int x = -320; x < 320; x += Pixels) {
    Direction ray;
    for (int axis = 0; axis < 3; ++axis)
      ray[axis] = focal * view.forward[axis] + x * view.right[axis] + y * view.down[axis];
    const Sighting now = look(scene, from, ray);
    const int entered = rooms_entered(before, now);
    if (entered == 0 && now.count == before.count && now.face == before.face) continue;
    line.clocks += RoomClocks * std::max(1, entered) + IntervalClocks;
    ++line.intervals;
    before = now;
  }
  return line;
}

}  // namespace

LineEstimate estimate_worst_line(const SceneFile& scene, const CameraPath& path) {
  LineEstimate worst;
  const int count = static_cast<int>(path.points.size());
  const int step = std::max(1, count / Frames);
  for (int frame = 0; frame < count; frame += step)
    for (int y = -240; y < 240; y += Lines) {
      const LineEstimate line = estimate_line(scene, path.points[frame], frame, y);
      if (line.clocks > worst.clocks) worst = line;
    }
  return worst;
}

}  // namespace racebeam
