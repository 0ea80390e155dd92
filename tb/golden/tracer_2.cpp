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
  /// Taken so far.
  int decisions() const { return decisions_; }

  /// Axis of the face by which the ray leaves the room.
  int exit(const GoldenRoom& room) {
    const vec3 far = corner(room, {1, 1, 1});
    return first(first(0, 1, far), 2, far);
  }

  /// Does the ray, leaving along `face`, go through the opening into the next room?
  bool enters(const GoldenRoom& next, int face) {
    vec3 side = {1, 1, 1};
    side[face] = -1;
    const vec3 far_edges = corner(next, side), near_edges = corner(next, {-1, -1, -1});
    const int one = (face + 2) % 3, other = (face + 1) % 3;
    for (const int edge : {one, other})  // past the opening's far edge
      if (first(face, edge, far_edges) == edge) return false;
    for (const int edge : {one, other})  // not yet at its near edge
      if (first(face, edge, near_edges) == face) return false;
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
  int first(int a, int b, const vec3& c) {
    ++decisions_;
    const int low = std::min(a, b), high = std::max(a, b);
    if (c[high] < 0) return high;
    if (c[low] < 0) return low;
    return c[high] * size_[low] <= c[low] * size_[high] ? high : low;
  }

  const GoldenWorld& world_;
  const int offset_z_;
  vec3 sign_, size_;
  int decisions_ = 0;
};

constexpr int None = -1;

/// Calls enter(room) for each room that the ray enters.
template <class Enter>
GoldenHit follow(const GoldenWorld& world, const vec3& dr, int offset_z, RayWork& work,
                 const Enter& enter) {
  Ray ray(world, dr, offset_z);
  const GoldenRoom* room = &world.rooms.front();
  ++work.rays;
  for (int depth = 0;; ++depth) {
    const int before = ray.decisions();
    const int face = ray.exit(*room);
    const auto& openings = room->neighbours[golden_face(face, ray.negative(face))];
    const bool is_solid = depth == world.room_depth || openings.empty();
    int entered = None;
    if (!is_solid)
      for (const int next : openings)
        if (entered == None && ray.enters(world.rooms[next], face)) entered = next;
    const int here = ray.decisions() - before;
    work.decisions += here;
    if (entered == None) {
      work.solid_hits += is_solid;
      work.solid_decisions += is_solid ? here : 0;
      return {face, ray.negative(face)};
    }
    ++work.rooms_entered;
    work.crossing_decisions += here;
    room = &world.rooms[entered];
    enter(entered);
  }
}

}  // namespace

GoldenHit trace_2(const GoldenWorld& world, const vec3& dr, int offset_z) {
  RayWork unseen;
  return follow(world, dr, offset_z, unseen, [](int) {});
}

GoldenWay trace_2_way(const GoldenWorld& world, const vec3& dr, int offset_z) {
  std::vector<int> rooms = {0};
  RayWork unseen;
  const GoldenHit hit =
      follow(world, dr, offset_z, unseen, [&](int room) { rooms.push_back(room); });
  return {hit, rooms};
}

GoldenHits trace_2_line(const GoldenWorld& world, const GoldenRays& rays, int y, RayWork* work) {
  RayWork unseen;
  GoldenHits hits;
  for (int pixel = 0; pixel < VisibleColumns; ++pixel)
    hits[pixel] = follow(world, rays[pixel], world.offset_z(y), work ? *work : unseen, [](int) {});
  return hits;
}

}  // namespace racebeam
