// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/tracer_2.h"

#include <algorithm>

namespace racebeam {

namespace {

/// One ray in the world mirrored so that it goes forward along all axes.
class Ray {
 public:
  Ray(const GoldenWorld& world, const vec3& dr, int offset_z) : world_(world), offset_z_(offset_z) {
    for (int a = 0; a < 3; ++a) {
      sign_[a] = dr[a] < 0 ? -1 : 1;
      size_[a] = dr[a] < 0 ? -dr[a] - 1 : dr[a];  // one's complement (contract 11.3)
    }
  }

  bool negative(int axis) const { return sign_[axis] < 0; }

  /// Axis of the face by which the ray leaves the room.
  int exit(const GoldenRoom& room) const {
    const vec3 far = corner(room, {1, 1, 1});
    return first(first(0, 1, far), 2, far);
  }

  /// Does the ray, leaving along `face`, go through the opening into the next room?
  bool enters(const GoldenRoom& next, int face) const {
    vec3 side = {1, 1, 1};
    side[face] = -1;
    const vec3 far_edges = corner(next, side), near_edges = corner(next, {-1, -1, -1});
    for (int edge = 0; edge < 3; ++edge) {
      if (edge == face) continue;
      if (first(face, edge, far_edges) == edge) return false;   // past the opening's far edge
      if (first(face, edge, near_edges) == face) return false;  // not yet at its near edge
    }
    return true;
  }

 private:
  /// A corner of the room: on each axis its far (1) or its near side (-1).
  vec3 corner(const GoldenRoom& room, const vec3& side) const {
    vec3 c;
    for (int a = 0; a < 3; ++a) {
      const int centre = room.position[a] + (a == 2 ? offset_z_ : 0);
      c[a] = world_.corner(sign_[a] * centre + side[a] * room.half_size[a]);
    }
    return c;
  }

  /// Which of the planes through the corner, across axis a or b, is reached first? A plane behind
  /// the camera was reached before; a tie goes to the higher axis.
  int first(int a, int b, const vec3& c) const {
    const int low = std::min(a, b), high = std::max(a, b);
    if (c[high] < 0) return high;
    if (c[low] < 0) return low;
    return c[high] * size_[low] <= c[low] * size_[high] ? high : low;
  }

  const GoldenWorld& world_;
  const int offset_z_;
  vec3 sign_, size_;
};

constexpr int None = -1;

/// Calls enter(room) for each room that the ray enters.
template <class Enter>
GoldenHit follow(const GoldenWorld& world, const vec3& dr, int offset_z, const Enter& enter) {
  const Ray ray(world, dr, offset_z);
  const GoldenRoom* room = &world.rooms.front();
  for (int depth = 0;; ++depth) {
    const int face = ray.exit(*room);
    int entered = None;
    if (depth < world.room_depth)
      for (const int next : room->neighbours[golden_face(face, ray.negative(face))])
        if (entered == None && ray.enters(world.rooms[next], face)) entered = next;
    if (entered == None) return {face, ray.negative(face)};
    room = &world.rooms[entered];
    enter(entered);
  }
}

}  // namespace

GoldenHit trace_2(const GoldenWorld& world, const vec3& dr, int offset_z) {
  return follow(world, dr, offset_z, [](int) {});
}

GoldenWay trace_2_way(const GoldenWorld& world, const vec3& dr, int offset_z) {
  std::vector<int> rooms = {0};
  const GoldenHit hit = follow(world, dr, offset_z, [&](int room) { rooms.push_back(room); });
  return {hit, rooms};
}

GoldenHits trace_2_line(const GoldenWorld& world, const GoldenRays& rays, int y) {
  GoldenHits hits;
  for (int pixel = 0; pixel < VisibleColumns; ++pixel)
    hits[pixel] = trace_2(world, rays[pixel], world.offset_z(y));
  return hits;
}

}  // namespace racebeam
