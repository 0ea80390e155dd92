// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/free_flight.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

constexpr double Pi = 3.14159265358979323846;
constexpr double Stride = 4;           // units: no room is thinner than two of them
constexpr double SteepestPitch = 440;  // a quarter turn is 512

// -half..half of a full turn.
double centred(double turn) { return turn - TurnUnits * std::round(turn / TurnUnits); }

// The farthest that the camera may be from the centre of a room along an axis.
double reach(const Room& room, int axis) {
  return std::max(room.half_size[axis] - FreeFlight::Margin, room.half_size[axis] / 2);
}

}  // namespace

FreeFlight::FreeFlight(const SceneFile& scene, const PathPoint& from, const GoldenView& view)
    : scene_(scene),
      room_(from.room),
      position_{1.0 * from.position[0], 1.0 * from.position[1], 1.0 * from.position[2]},
      yaw_(view.yaw),
      pitch_(std::clamp(centred(view.pitch), -SteepestPitch, SteepestPitch)),
      fov_(view.fov) {
  for (int axis = 0; axis < 3; ++axis) step(axis, 0);
}

void FreeFlight::turn(double right, double down) {
  yaw_ = centred(yaw_ + right);
  pitch_ = std::clamp(pitch_ + down, -SteepestPitch, SteepestPitch);
}

void FreeFlight::move(double ahead, double right, double up) {
  const double yaw = yaw_ / TurnUnits * 2 * Pi, pitch = pitch_ / TurnUnits * 2 * Pi;
  const double east = std::sin(yaw) * std::cos(pitch), north = std::cos(yaw) * std::cos(pitch);
  const double way[3] = {ahead * east + right * std::cos(yaw), ahead * std::sin(pitch) - up,
                         ahead * north - right * std::sin(yaw)};
  const double length = std::hypot(way[0], way[1], way[2]);
  const int strides = static_cast<int>(std::ceil(length / Stride));
  for (int i = 0; i < strides; ++i)
    for (int axis = 0; axis < 3; ++axis) step(axis, way[axis] / strides);
}

// Along one axis: on, through a portal, or up to the wall.
void FreeFlight::step(int axis, double by) {
  position_[axis] += by;
  const Room& room = scene_.rooms[room_];
  const double limit = reach(room, axis);
  if (std::abs(position_[axis]) <= limit) return;
  const int face = 2 * axis + (position_[axis] < 0);
  Vector rounded;
  for (int a = 0; a < 3; ++a) rounded[a] = static_cast<int>(std::lround(position_[a]));
  // Is there a portal where it looks through the face?
  Vector beyond = rounded;
  beyond[axis] = (position_[axis] < 0 ? -1 : 1) * (room.half_size[axis] + 1);
  PathPoint there{room_, beyond};
  if (!cross_portal(scene_, face, there)) {
    position_[axis] = std::clamp(position_[axis], -limit, limit);
    return;
  }
  if (std::abs(position_[axis]) <= room.half_size[axis]) return;
  for (int a = 0; a < 3; ++a) position_[a] += there.position[a] - beyond[a];
  room_ = there.room;
  // A door frame pushes the camera to its middle.
  for (int a = 0; a < 3; ++a) {
    if (a == axis) continue;
    const double side = reach(scene_.rooms[room_], a);
    const int near = position_[a] < 0 ? 2 * a + 1 : 2 * a;
    if (std::abs(position_[a]) > side && scene_.rooms[room_].portals[near].empty())
      position_[a] = std::clamp(position_[a], -side, side);
  }
}

Pose FreeFlight::pose() const {
  Pose pose;
  pose.room = room_;
  const Room& room = scene_.rooms[room_];
  for (int a = 0; a < 3; ++a)
    pose.position[a] = std::clamp(static_cast<int>(std::lround(position_[a])),
                                  1 - room.half_size[a], room.half_size[a] - 1);
  pose.yaw = static_cast<int>(std::lround(yaw_)) & (TurnUnits - 1);
  pose.pitch = static_cast<int>(std::lround(pitch_)) & (TurnUnits - 1);
  pose.fov = fov_;
  return pose;
}

}  // namespace racebeam
