// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_storeys.h"

#include <algorithm>

namespace racebeam {

namespace {

bool above_each_other(const Room& a, const Room& b) {
  for (const int axis : {0, 2})
    if (a.high(axis) <= b.low(axis) || b.high(axis) <= a.low(axis)) return false;
  return true;
}

// From the lowest floor; y points down.
void sort_by_floor(const SceneFile& scene, std::vector<int>& rooms) {
  std::stable_sort(rooms.begin(), rooms.end(),
                   [&](int a, int b) { return scene.rooms[a].high(1) > scene.rooms[b].high(1); });
}

// Rooms with one floor begin a storey as soon as one of them is above a room of the last one.
void stack(const SceneFile& scene, std::vector<int> rooms, std::vector<Storey>& to) {
  sort_by_floor(scene, rooms);
  const std::string set = scene.rooms[rooms.front()].set;
  const std::size_t before = to.size();
  for (std::size_t first = 0, end = 0; first < rooms.size(); first = end) {
    while (end < rooms.size() &&
           scene.rooms[rooms[end]].high(1) == scene.rooms[rooms[first]].high(1))
      ++end;
    bool begins = to.size() == before;
    for (std::size_t i = first; i < end && !begins && !scene.overlap; ++i)
      for (const int below : to.back().rooms)
        begins = begins || above_each_other(scene.rooms[rooms[i]], scene.rooms[below]);
    if (begins) to.push_back({set, static_cast<int>(to.size() - before) + 1, {}});
    to.back().rooms.insert(to.back().rooms.end(), rooms.begin() + first, rooms.begin() + end);
  }
}

int storey_of(const std::vector<Storey>& storeys, int room) {
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    for (const auto* rooms : {&storeys[i].rooms, &storeys[i].shafts})
      if (std::find(rooms->begin(), rooms->end(), room) != rooms->end()) return static_cast<int>(i);
  }
  return -1;
}

// Shafts go to the room below them, or else to the one that they lead down from. One that no room
// leads to is with the first storey of its set.
void add_shaft(const SceneFile& scene, int shaft, std::vector<Storey>& storeys) {
  const Room& room = scene.rooms[shaft];
  for (const Face face : {Down, Up})
    for (const int next : room.portals[face])
      if (const int storey = storey_of(storeys, next); storey >= 0) {
        storeys[storey].shafts.push_back(shaft);
        return;
      }
  for (Storey& storey : storeys)
    if (storey.set == room.set) {
      storey.shafts.push_back(shaft);
      return;
    }
}

Vector place_of(const SceneFile& scene, const PathPoint& point) {
  Vector place = scene.rooms[point.room].centre;
  for (int axis = 0; axis < 3; ++axis) place[axis] += point.position[axis];
  return place;
}

// Whether the camera has flown from `a` to `b`, and not been moved by a portal that leads
// elsewhere.
bool flown(const Vector& a, const Vector& b, const Vector& velocity) {
  for (int axis = 0; axis < 3; ++axis)
    if (b[axis] != a[axis] && b[axis] - a[axis] != velocity[axis]) return false;
  return true;
}

bool is_shaft(const SceneFile& scene, const Room& room) {
  for (const Face face : {East, West, North, South})
    if (!room.portals[face].empty()) return false;
  bool lower = true, smaller = true;  // than all rooms that it leads to
  int ways = 0;
  for (const Face face : {Down, Up})
    for (const int number : room.portals[face]) {
      const Room& next = scene.rooms[number];
      ++ways;
      lower = lower && room.half_size[1] < next.half_size[1];
      for (const int axis : {0, 2})
        smaller = smaller && room.half_size[axis] < next.half_size[axis];
    }
  return ways > 0 && (lower || smaller);
}

}  // namespace

std::vector<Storey> storeys_of(const SceneFile& scene) {
  std::vector<std::string> sets;
  for (const Room& room : scene.rooms)
    if (std::find(sets.begin(), sets.end(), room.set) == sets.end()) sets.push_back(room.set);
  std::vector<Storey> storeys;
  for (const std::string& set : sets) {
    std::vector<int> rooms, shafts;
    for (std::size_t i = 0; i < scene.rooms.size(); ++i)
      if (scene.rooms[i].set == set)
        (is_shaft(scene, scene.rooms[i]) ? shafts : rooms).push_back(static_cast<int>(i));
    if (rooms.empty()) rooms.swap(shafts);  // nothing but boxes on top of each other
    stack(scene, rooms, storeys);
    for (const int shaft : shafts) add_shaft(scene, shaft, storeys);
  }
  return storeys;
}

std::vector<Strand> strands_of(const SceneFile& scene, const CameraPath& path,
                               const std::vector<Storey>& storeys) {
  std::vector<int> storey(scene.rooms.size(), 0);
  for (std::size_t i = 0; i < storeys.size(); ++i)
    for (const auto* rooms : {&storeys[i].rooms, &storeys[i].shafts})
      for (const int room : *rooms) storey[room] = static_cast<int>(i);
  std::vector<Strand> strands;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const int frame = static_cast<int>(i), here = storey[path.points[i].room];
    const Vector place = place_of(scene, path.points[i]);
    const Shot& shot = scene.shot_at(frame);
    const bool jumps = shot.frame == frame && shot.restart;
    const Vector& velocity = scene.shot_at(std::max(frame - 1, 0)).camera.velocity;
    const bool goes_on =
        !jumps && !strands.empty() && flown(strands.back().points.back().place, place, velocity);
    if (!goes_on || strands.back().storey != here) {
      Strand next{here, jumps, {}};
      if (goes_on) next.points.push_back(strands.back().points.back());
      strands.push_back(std::move(next));
    }
    strands.back().points.push_back({frame, place});
  }
  return strands;
}

}  // namespace racebeam
