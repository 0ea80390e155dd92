// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_file.h"

#include <algorithm>

namespace racebeam {

const char* face_name(int face) {
  static const char* const names[FaceCount] = {"east", "west", "down", "up", "north", "south"};
  return names[face];
}

bool rooms_overlap(const Room& a, const Room& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.high(axis) <= b.low(axis) || b.high(axis) <= a.low(axis)) return false;
  return true;
}

bool rooms_touch(const Room& a, int face, const Room& b) {
  const int normal = face_axis(face);
  if (face == 2 * normal ? a.high(normal) != b.low(normal) : a.low(normal) != b.high(normal))
    return false;
  for (int axis = 0; axis < 3; ++axis)
    if (axis != normal && (a.high(axis) <= b.low(axis) || b.high(axis) <= a.low(axis)))
      return false;
  return true;
}

int Turn::value(int frame, int y, int units) const {
  const long long steps = (frame - since) / every;
  const long long sum = start + step * steps + static_cast<long long>(per_line) * y;
  return static_cast<int>((sum % units + units) % units);
}

const Shot& SceneFile::shot_at(int frame) const {
  const auto after =
      std::upper_bound(shots.begin(), shots.end(), frame,
                       [](int wanted, const Shot& shot) { return wanted < shot.frame; });
  return *std::prev(after);
}

namespace {

void connect_once(Room& room, int face, int to) {
  std::vector<int>& known = room.portals[face];
  if (std::find(known.begin(), known.end(), to) == known.end()) known.push_back(to);
}

}  // namespace

void connect(std::vector<Room>& rooms, int a, int face, int b) {
  connect_once(rooms[a], face, b);
  connect_once(rooms[b], opposite(face), a);
}

int count_portals(const SceneFile& scene) {
  int sides = 0;
  for (const Room& room : scene.rooms)
    for (const std::vector<int>& face : room.portals) sides += static_cast<int>(face.size());
  return sides / 2;
}

}  // namespace racebeam
