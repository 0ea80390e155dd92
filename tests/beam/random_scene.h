// Random worlds: a box cut into rooms, faces with several portals, a camera on its way.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tb/scene/camera_path.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

class RandomScene {
 public:
  /// Of the size of the chip's scenes, or `edge` units wide.
  explicit RandomScene(unsigned seed, int edge = 1200) : random_(seed) {
    cut({0, 0, 0}, {edge, edge, edge}, 0);
    open_portals();
    scene_.name = "random " + std::to_string(seed);
    scene_.shots.emplace_back();
    place_camera(scene_.shots[0].camera);
    scene_.frames = LongestFlight;
    if (const auto end = fly(scene_).end) scene_.frames = end->frame;
  }

  const SceneFile& scene() const { return scene_; }

 private:
  static constexpr int Smallest = 48, Cuts = 6, LongestFlight = 600;

  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  int between(int low, int high) { return low + below(high - low + 1); }

  // Cuts a box in two, again and again; sizes stay even.
  void cut(const Vector& low, const Vector& high, int cuts) {
    const int axis = below(3), size = high[axis] - low[axis];
    if (cuts == Cuts || size < 2 * Smallest || (cuts > 2 && below(8) == 0)) {
      Room room;
      room.id = std::to_string(scene_.rooms.size());
      for (int a = 0; a < 3; ++a) {
        room.half_size[a] = (high[a] - low[a]) / 2;
        room.centre[a] = low[a] + room.half_size[a];
      }
      scene_.rooms.push_back(room);
      return;
    }
    const int at = low[axis] + between(Smallest, size - Smallest) / 2 * 2;
    Vector middle_high = high, middle_low = low;
    middle_high[axis] = middle_low[axis] = at;
    cut(low, middle_high, cuts + 1);
    cut(middle_low, high, cuts + 1);
  }

  void open_portals() {
    std::vector<Room>& rooms = scene_.rooms;
    const int count = static_cast<int>(rooms.size());
    const auto full = [&](int room, int face) {
      return rooms[room].portals[face].size() == PortalsPerFace;
    };
    for (int a = 0; a < count; ++a)
      for (int face = 0; face < FaceCount; face += 2)
        for (int b = 0; b < count; ++b)
          if (rooms_touch(rooms[a], face, rooms[b]) && below(5) > 0 && !full(a, face) &&
              !full(b, opposite(face)))
            connect(rooms, a, face, b);
    for (Room& room : rooms)  // in any order
      for (auto& portals : room.portals) std::shuffle(portals.begin(), portals.end(), random_);
  }

  void place_camera(Camera& camera) {
    camera.room = below(static_cast<int>(scene_.rooms.size()));
    for (int a = 0; a < 3; ++a) {
      const int half = scene_.rooms[camera.room].half_size[a];
      camera.position[a] = between(1 - half, half - 1);
      camera.velocity[a] = between(-9, 9);
    }
    camera.yaw = {below(TurnUnits), between(-9, 9), between(1, 3), between(-1, 1), 0};
    camera.pitch = {below(TurnUnits), between(-5, 5), between(1, 3), 0, 0};
    camera.fov = {between(60, 220), 0, 1, 0, 0};
  }

  std::mt19937 random_;
  SceneFile scene_;
};

}  // namespace racebeam
