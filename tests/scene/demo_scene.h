// The chip's geometries and the scene files that say the same, room by room.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <ostream>
#include <set>

#include "sc/beam/chip_core.h"
#include "tests/support/scene_text.h"

namespace racebeam {

constexpr int SightDepth = VisibleRooms + 1;     // portals
constexpr int CameraColumn = 4;                  // i of the camera's rooms
constexpr int InsideGate = 0, OutsideGate = 64;  // values of dr2_y: contract 17.4

inline const SceneFile& demo() {
  static const SceneFile scene = [] {
    SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/demo.toml");
    EXPECT_EQ(result.faults.text("demo.toml"), "");
    return std::move(result.scene);
  }();
  return scene;
}

/// One geometry: its set in the demo, its own file, the chip's flags (contract 17.1), and a frame
/// of the demo from which on it is shown with the colours of that table.
struct Geometry {
  const char *set, *file;
  int flags, frame;
};

/// For the names of tests.
inline void PrintTo(const Geometry& geometry, std::ostream* out) { *out << geometry.file; }

inline const Geometry Geometries[] = {
    {"pillars", "pillars", SceneWindows | SceneBlocked, 0},
    {"tunnel", "tunnel", SceneTunnel, 4096},
    {"heights", "heights", SceneHeights, 6144},
    {"heights_pillars", "heights_pillars", SceneHeights | SceneBlocked, 9216},
    {"portals_narrow", "portals", SceneWindows | ScenePortals | SceneBlocked | SceneNarrow, 10240},
    {"tunnel_narrow", "tunnel_narrow", SceneTunnel | SceneNarrow, 12288},
    {"heights_narrow", "heights_narrow", SceneHeights | SceneNarrow, 9984},
};

inline const Geometry& geometry_of(int flags) {
  for (const Geometry& geometry : Geometries)
    if (geometry.flags == flags) return geometry;
  ADD_FAILURE() << "flags " << flags;
  return Geometries[0];
}

/// The file's room of each of the chip's.
using Rooms = std::map<int, int>;

inline vec3 minus(const vec3& a, const vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline vec3 modulo_corner(vec3 v) {
  for (int& value : v) value = wrap_signed(value, CornerBits);
  return v;
}
inline vec3 to_vec3(const Vector& v) { return {v[0], v[1], v[2]}; }

/// Both worlds in step, breadth first through all faces from one room.
inline void walk(const SceneFile& scene, int flags, int chip_start, int file_start, Rooms& rooms) {
  const vec3 chip_origin = scene_core::geometry(flags, chip_start).position;
  const vec3 file_origin = to_vec3(scene.rooms[file_start].centre);
  std::set<int> met{chip_start};
  std::vector<int> now{chip_start}, next;
  rooms.emplace(chip_start, file_start);
  for (int depth = 0; depth <= SightDepth; ++depth, now.swap(next), next.clear())
    for (const int id : now) {
      const Room& room = scene.rooms[rooms.at(id)];
      const auto chip = scene_core::geometry(flags, id);
      ASSERT_EQ(to_vec3(room.half_size), chip.half_size) << room.id;
      ASSERT_EQ(modulo_corner(minus(to_vec3(room.centre), file_origin)),
                modulo_corner(minus(chip.position, chip_origin)))
          << room.id;
      for (int face = 0; depth < SightDepth && face < FaceCount; ++face) {
        const int behind = scene_core::neighbour(flags, id, face_axis(face), face % 2 == 1);
        const std::vector<int>& portals = room.portals[face];
        ASSERT_EQ(portals.size(), behind == SolidRoom ? 0U : 1U)
            << face_name(face) << " of " << room.id;
        if (behind == SolidRoom) continue;
        const auto [at, added] = rooms.emplace(behind, portals[0]);
        ASSERT_EQ(at->second, portals[0]) << face_name(face) << " of " << room.id;
        if (met.insert(behind).second) next.push_back(behind);
      }
    }
}

/// Walks from the start of a flight and then from each room that the camera comes to. The flight's
/// first room in the file is `start`.
inline Rooms rooms_in_step(const SceneFile& scene, int flags, int start) {
  Rooms rooms{{CameraColumn, start}};
  const int last = flags & SceneTunnel ? 15 : 8;
  for (int j = 0; j <= last; ++j) {
    const int room = j << 4 | CameraColumn;
    if (!rooms.count(room)) ADD_FAILURE() << "no room in ring " << j;
    else walk(scene, flags, room, rooms.at(room), rooms);
  }
  return rooms;
}

/// Rooms of the demo's geometries by the chip's flags, each from its first shot.
inline const std::map<int, Rooms>& demo_rooms() {
  static const std::map<int, Rooms> all = [] {
    std::map<int, Rooms> rooms;
    for (const Shot& shot : demo().shots) {
      const std::string& set = demo().rooms[shot.camera.room].set;
      for (const Geometry& geometry : Geometries)
        if (set == geometry.set && !rooms.count(geometry.flags))
          rooms[geometry.flags] = rooms_in_step(demo(), geometry.flags, shot.camera.room);
    }
    return rooms;
  }();
  return all;
}

inline sequencer_core::outputs choices(int frame, int dr2_y) {
  sequencer_core sequencer;
  sequencer.frame_q = frame;
  return sequencer.comb({true, false, true, dr2_y}, {});
}

/// Contract 15.2.
inline const Palette Palettes[] = {{0, 1, 6, 43}, {2, 6, 26, 30}, {17, 37, 57, 62}};

/// Contract 17.3, in lines of all parts of the picture.
inline void expect_turns(const SceneFile& scene, const sequencer_core& sequencer, int frame) {
  const Camera& camera = scene.shot_at(frame).camera;
  for (const int y : {-240, -1, 0, 100, 239}) {
    ASSERT_EQ(camera.yaw.value(frame, y, TurnUnits), sequencer.angle(AngleYaw, y))
        << "frame " << frame << ", y " << y;
    ASSERT_EQ(camera.pitch.value(frame, y, TurnUnits), sequencer.angle(AnglePitch, y))
        << "frame " << frame << ", y " << y;
    ASSERT_EQ(camera.fov.value(frame, y, FocalUnits), sequencer.angle(AngleFov, y))
        << "frame " << frame << ", y " << y;
  }
}

}  // namespace racebeam
