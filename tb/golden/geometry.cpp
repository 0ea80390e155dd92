// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace racebeam {

namespace {

/// A room with the camera at the origin.
struct Box {
  GoldenVector low, high;
  Box(const GoldenRoom& room, int offset_z) {
    for (int a = 0; a < 3; ++a) {
      const int centre = room.position[a] + (a == 2 ? offset_z : 0);
      low[a] = centre - room.half_size[a];
      high[a] = centre + room.half_size[a];
    }
  }
};

/// Does the ray, which has left a room along axis `face` at the distance `left`, go through the
/// opening into the next room? The opening is that room's near face. One behind the camera is none:
/// the tunnel has copies of a room beside it that do not begin where it ends.
bool enters(const Box& next, const GoldenVector& ray, int face, double left) {
  const double distance = (ray[face] < 0 ? next.high[face] : next.low[face]) / ray[face];
  if (distance < std::min(left, 0.0)) return false;
  for (int a = 0; a < 3; ++a) {
    const double point = distance * ray[a];
    if (a != face && (point < next.low[a] || point > next.high[a])) return false;
  }
  return true;
}

}  // namespace

GoldenEnd geometry_end(const GoldenWorld& world, const GoldenVector& ray, int offset_z) {
  const GoldenRoom* room = &world.rooms.front();
  for (int depth = 0;; ++depth) {
    const Box box(*room, offset_z);
    int face = 2;
    double nearest = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
      if (ray[a] == 0) continue;
      const double distance = (ray[a] < 0 ? box.low[a] : box.high[a]) / ray[a];
      if (distance < nearest) nearest = distance, face = a;
    }
    const GoldenHit hit{face, ray[face] < 0};
    const GoldenRoom* entered = nullptr;
    if (depth < world.room_depth)
      for (const int next : room->neighbours[golden_face(face, hit.negative)])
        if (!entered && enters({world.rooms[next], offset_z}, ray, face, nearest))
          entered = &world.rooms[next];
    if (!entered) return {hit, static_cast<int>(room - world.rooms.data()), depth};
    room = entered;
  }
}

GoldenHit geometry(const GoldenWorld& world, const GoldenVector& ray, int offset_z) {
  return geometry_end(world, ray, offset_z).hit;
}

GoldenHits geometry_line(const GoldenWorld& world, const GoldenIdeal& camera, int y) {
  GoldenHits hits;
  for (int pixel = 0; pixel < VisibleColumns; ++pixel)
    hits[pixel] = geometry(world, camera.ray(pixel), world.offset_z(y));
  return hits;
}

}  // namespace racebeam
