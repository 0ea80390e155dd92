// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_sight.h"

#include <algorithm>
#include <vector>

namespace racebeam {

namespace {

constexpr int Octants = 8;  // bit a: towards negative coordinates of axis a

int face_of(int octant, int axis) { return 2 * axis + (octant >> axis & 1); }

long long corner_distance(const Room& from, const Room& to) {
  long long distance = 0;
  for (int axis = 0; axis < 3; ++axis)
    distance = std::max({distance, static_cast<long long>(to.high(axis)) - from.low(axis),
                         static_cast<long long>(from.high(axis)) - to.low(axis)});
  return distance;
}

// Breadth first through the portals of one octant.
class Sight {
 public:
  explicit Sight(const SceneFile& scene) : scene_(scene), seen_(scene.rooms.size(), -1) {}

  // Calls use(room) for each room in sight, the first one too.
  template <class Use>
  void look(int from, int octant, const Use& use) {
    ++stamp_;
    rooms_.assign(1, from);
    seen_[from] = stamp_;
    std::size_t done = 0;
    for (int depth = 0; depth <= VisibleRooms; ++depth) {
      const std::size_t end = rooms_.size();
      for (; done < end; ++done) {
        use(rooms_[done]);
        if (depth < VisibleRooms) enter(rooms_[done], octant);
      }
    }
  }

 private:
  void enter(int room, int octant) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int next : scene_.rooms[room].portals[face_of(octant, axis)]) {
        if (seen_[next] == stamp_) continue;
        seen_[next] = stamp_;
        rooms_.push_back(next);
      }
  }

  const SceneFile& scene_;
  std::vector<int> seen_;  // stamp of the last look that met the room
  std::vector<int> rooms_;
  int stamp_ = -1;
};

}  // namespace

FarCorner farthest_corner(const SceneFile& scene) {
  FarCorner far;
  Sight sight(scene);
  for (int from = 0; from < static_cast<int>(scene.rooms.size()); ++from)
    for (int octant = 0; octant < Octants; ++octant)
      sight.look(from, octant, [&](int to) {
        const long long distance = corner_distance(scene.rooms[from], scene.rooms[to]);
        if (distance > far.distance) far = {distance, from, to};
      });
  return far;
}

int deepest_view(const SceneFile& scene) {
  const std::size_t count = scene.rooms.size();
  int deepest = 0;
  for (int octant = 0; octant < Octants; ++octant) {
    // Whether a way of `depth` portals starts in each room.
    std::vector<char> now(count, 1), next(count);
    for (int depth = 1; depth <= VisibleRooms; ++depth) {
      bool any = false;
      for (std::size_t room = 0; room < count; ++room) {
        next[room] = 0;
        for (int axis = 0; axis < 3; ++axis)
          for (const int to : scene.rooms[room].portals[face_of(octant, axis)])
            next[room] |= now[to];
        any |= next[room] != 0;
      }
      if (!any) break;
      deepest = std::max(deepest, depth);
      now.swap(next);
    }
  }
  return deepest;
}

}  // namespace racebeam
