// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/geometry.h"

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

}  // namespace

GoldenHit geometry(const GoldenWorld& world, const GoldenVector& ray, int offset_z) {
  int room = 0;
  for (int depth = 0;; ++depth) {
    const Box box(world.rooms[room], offset_z);
    int face = 2;
    double nearest = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
      if (ray[a] == 0) continue;
      const double distance = (ray[a] < 0 ? box.low[a] : box.high[a]) / ray[a];
      if (distance < nearest) nearest = distance, face = a;
    }
    const GoldenHit hit{face, ray[face] < 0};
    const int next = world.rooms[room].neighbour[golden_face(face, hit.negative)];
    if (depth == world.room_depth || next < 0) return hit;
    const Box beyond(world.rooms[next], offset_z);
    // The tunnel has copies of a room beside it that do not begin where it ends: walls.
    const bool touches =
        hit.negative ? beyond.high[face] == box.low[face] : beyond.low[face] == box.high[face];
    if (!touches) return hit;
    for (int a = 0; a < 3; ++a) {
      const double point = nearest * ray[a];
      if (a != face && (point < beyond.low[a] || point > beyond.high[a])) return hit;
    }
    room = next;
  }
}

GoldenHits geometry_line(const GoldenWorld& world, const GoldenIdeal& camera, int y) {
  GoldenHits hits;
  for (int pixel = 0; pixel < VisibleColumns; ++pixel)
    hits[pixel] = geometry(world, camera.ray(pixel), world.offset_z(y));
  return hits;
}

}  // namespace racebeam
