// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_check.h"

#include <algorithm>
#include <numeric>

#include "tb/scene/camera_path.h"
#include "tb/scene/scene_sight.h"

namespace racebeam {

namespace {

int unsigned_bits(long long value) {
  int bits = 0;
  for (; value > 0; value >>= 1) ++bits;
  return bits;
}

// Rooms sorted by their west end are compared only while they share some x. One fault a room.
void check_overlaps(const SceneFile& scene, Faults& faults) {
  const std::vector<Room>& rooms = scene.rooms;
  std::vector<int> order(rooms.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return rooms[a].low(0) < rooms[b].low(0); });
  std::vector<int> first(rooms.size(), -1);  // the earlier room that each later one overlaps
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto [a, b] = std::minmax(order[i], order[j]);
      if (rooms[order[j]].low(0) >= rooms[order[i]].high(0)) break;
      if (!rooms_overlap(rooms[a], rooms[b]) || rooms[a].set != rooms[b].set) continue;
      if (first[b] < 0 || a < first[b]) first[b] = a;
    }
  for (std::size_t b = 0; b < rooms.size(); ++b)
    if (first[b] >= 0)
      faults.add(rooms[b].place,
                 "rooms " + quoted(rooms[first[b]].id) + " and " + quoted(rooms[b].id) + " overlap",
                 "move or shrink one of them, or give them different sets; the other is in line " +
                     std::to_string(rooms[first[b]].place.line));
}

void check_faces(const SceneFile& scene, Faults& faults) {
  for (const Room& room : scene.rooms)
    for (int face = 0; face < FaceCount; ++face)
      if (room.portals[face].size() > PortalsPerFace)
        faults.add(room.place,
                   "the " + std::string(face_name(face)) + " face of " + quoted(room.id) + " has " +
                       std::to_string(room.portals[face].size()) + " portals",
                   "a face holds up to four; split the room");
}

// The chip adds the camera's place and half a room: a sum that does not fit would lose the camera.
void check_reach(const SceneFile& scene, const CameraPath& path, Faults& faults) {
  if (scene.corner_bits == 0 || path.reach < 1 << (scene.corner_bits - 1)) return;
  const Room& room = scene.rooms[path.reach_room];
  faults.add(room.place,
             "the camera cannot fly in " + quoted(room.id) +
                 ": its place and half the room add to " + std::to_string(path.reach) + "; " +
                 std::to_string(scene.corner_bits) + " corner bits reach to " +
                 std::to_string((1 << (scene.corner_bits - 1)) - 1),
             "raise or drop 'corner_bits', or make the room smaller");
}

void check_path(const SceneFile& scene, Faults& faults) {
  const CameraPath path = fly(scene);
  check_reach(scene, path, faults);
  if (!path.end) return;
  const Shot& shot = scene.shot_at(path.end->frame - 1);
  const Room& room = scene.rooms[path.end->room];
  const char* reason =
      room.portals[path.end->face].empty() ? ", which has no portal" : " beside its portal";
  faults.add(shot.place,
             "in frame " + std::to_string(path.end->frame) + " the camera leaves " +
                 quoted(room.id) + " through its " + face_name(path.end->face) + " face" + reason,
             "change 'velocity' or 'position', add a [[shot]] before that frame, or end there: "
             "frames = " +
                 std::to_string(path.end->frame));
}

}  // namespace

SceneWidths scene_widths(const SceneFile& scene) {
  SceneWidths widths;
  widths.room_bits = unsigned_bits(static_cast<long long>(scene.rooms.size()));
  const CameraPath path = fly(scene);
  const long long farthest = std::max<long long>(farthest_corner(scene).distance, path.reach);
  widths.corner_bits = std::max(MinCornerBits, unsigned_bits(farthest) + 1);
  widths.camera_bits = unsigned_bits(path.largest) + 1;
  for (const Room& room : scene.rooms)
    for (const std::vector<int>& face : room.portals)
      widths.portals_per_face = std::max(widths.portals_per_face, static_cast<int>(face.size()));
  return widths;
}

int built_corner_bits(const SceneFile& scene, const SceneWidths& widths) {
  if (scene.corner_bits > 0) return scene.corner_bits;
  return std::min(widths.corner_bits, MaxCornerBits);
}

void check_rooms(const SceneFile& scene, Faults& faults) {
  if (!scene.overlap) check_overlaps(scene, faults);
  check_faces(scene, faults);
}

void check_views(const SceneFile& scene, Faults& faults) {
  check_path(scene, faults);
  const int bits = scene.corner_bits > 0 ? scene.corner_bits : MaxCornerBits;
  const FarCorner far = farthest_corner(scene);
  if (scene.wrap || far.distance < 1LL << (bits - 1)) return;
  const Room& from = scene.rooms[far.from];
  const Room& to = scene.rooms[far.to];
  faults.add(to.place,
             "seen from " + quoted(from.id) + ", a corner of " + quoted(to.id) + " is " +
                 std::to_string(far.distance) + " away; " + std::to_string(bits) +
                 " corner bits reach to " + std::to_string((1LL << (bits - 1)) - 1),
             bits < MaxCornerBits
                 ? "raise or drop 'corner_bits', make rooms smaller, or allow it: wrap = true"
                 : "make rooms smaller, or allow it: wrap = true");
}

void warn_of_lost_rooms(const SceneFile& scene, Faults& faults) {
  std::vector<bool> reached(scene.rooms.size(), false);
  // Reaches all that can be reached from a room; how many those are.
  const auto reach = [&](int start) {
    std::vector<int> next = {start};
    int count = 0;
    while (!next.empty()) {
      const int room = next.back();
      next.pop_back();
      if (reached[room]) continue;
      reached[room] = true;
      ++count;
      for (const std::vector<int>& face : scene.rooms[room].portals)
        next.insert(next.end(), face.begin(), face.end());
    }
    return count;
  };
  for (const Shot& shot : scene.shots)
    if (shot.restart) reach(shot.camera.room);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    if (reached[i]) continue;
    const int others = reach(static_cast<int>(i)) - 1;
    faults.warn(scene.rooms[i].place,
                "nothing leads to " + quoted(scene.rooms[i].id) +
                    (others > 0 ? " and " + std::to_string(others) + " more" : ""),
                "join it to a room by a portal, set the camera down in it by a [[shot]], or leave "
                "it out");
  }
}

}  // namespace racebeam
