// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sc/sphere/first_hit.h"
#include "sc/voxel/voxel_world.h"
#include "tb/scene/voxel_terrain.h"

namespace racebeam {

namespace {

int rounded(double number) { return static_cast<int>(std::lround(number)); }

/// The first column whose middle is not below a coordinate.
int column_from(double coordinate) { return static_cast<int>(std::ceil(coordinate - 0.5)); }

std::size_t wrapped_index(int x, int y, const vec3& size) {
  return static_cast<std::size_t>(voxel_wrapped(y, size[1])) * static_cast<std::size_t>(size[0]) +
         static_cast<std::size_t>(voxel_wrapped(x, size[0]));
}

/// Columns of a room: low <= x < high.
struct Ground {
  int x_low, x_high, y_low, y_high;
};
Ground ground_of(const Room& room, double scale) {
  return {column_from(scale * room.low(0)), column_from(scale * room.high(0)),
          column_from(scale * room.low(2)), column_from(scale * room.high(2))};
}

int wall_of(int room, int face) { return 2 * room * FaceCount + face; }

VoxelSolids filled(const voxel_column& column, int lower, int upper, const vec3& size) {
  const std::size_t count = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  VoxelSolids solids{std::vector<std::uint32_t>(count, packed(column)), {}};
  for (std::size_t n = 0; n < count; ++n) {
    solids.objects.push_back(lower);
    solids.objects.push_back(upper);
  }
  return solids;
}

void set_objects(int object, int x, int y, const vec3& size, VoxelSolids& solids) {
  const std::size_t index = wrapped_index(x, y, size);
  solids.objects[2 * index] = solids.objects[2 * index + 1] = object;
}

/// Whether they have the ground, or a part of it, in common.
bool above_each_other(const Room& a, const Room& b) {
  return std::max(a.low(0), b.low(0)) < std::min(a.high(0), b.high(0)) &&
         std::max(a.low(2), b.low(2)) < std::min(a.high(2), b.high(2));
}

bool connected(const Room& from, int to) {
  return std::any_of(from.portals.begin(), from.portals.end(), [&](const std::vector<int>& face) {
    return std::find(face.begin(), face.end(), to) != face.end();
  });
}

bool touch(const Room& a, const Room& b) {
  for (const int face : {East, West, North, South})
    if (rooms_touch(a, face, b)) return true;
  return false;
}

void check_storey(const std::vector<Room>& rooms, Place at, Faults& faults) {
  int above = 0, walls = 0;
  for (std::size_t n = 0; n < rooms.size(); ++n)
    for (std::size_t m = 0; m < n; ++m) {
      const Room &a = rooms[m], &b = rooms[n];
      const std::string both = "rooms " + quoted(a.id) + " and " + quoted(b.id);
      if (above_each_other(a, b)) {
        if (above++ == 0)
          faults.add(at, both + " stand above each other, or in each other",
                     "a column has one room: leave one storey, and rooms of one set");
      } else if (connected(a, static_cast<int>(n)) && !touch(a, b)) {
        faults.add(at,
                   "a portal leads from " + quoted(a.id) + " to " + quoted(b.id) +
                       ", which does not touch it",
                   "a voxel world has no such portals: move the rooms together");
      } else if (!connected(a, static_cast<int>(n)) && touch(a, b) && walls++ == 0) {
        faults.warn(at, both + " touch, and no portal leads through",
                    "there will be no wall between them: move them apart by a unit");
      }
    }
}

/// A room that does not fit is a fault; one is enough.
bool check_room(const Room& room, const VoxelMapping& map, Place at, Faults& faults) {
  const int floor = map.base - rounded(map.scale * room.high(1));
  const int ceiling = map.base - rounded(map.scale * room.low(1));
  const bool high = ceiling > voxel_top(map.size);
  if (floor >= 0 && !high) return true;
  faults.add(at,
             fmt::format("room {} is from {} to {} high; the world from 0 to {}", quoted(room.id),
                         floor, ceiling, voxel_top(map.size)),
             high ? "make the world's size larger, or scale or floor smaller"
                  : "make base larger, or leave it out");
  return false;
}

bool check_extent(const std::vector<Room>& rooms, const VoxelMapping& map, Place at,
                  Faults& faults) {
  for (const int axis : {0, 2}) {
    int low = rooms.front().low(axis), high = rooms.front().high(axis);
    for (const Room& room : rooms) {
      low = std::min(low, room.low(axis));
      high = std::max(high, room.high(axis));
    }
    const int side = map.size[axis / 2];
    if (map.scale * (high - low) <= side) continue;
    faults.add(at,
               fmt::format("the rooms are {:g} wide along {}; the world is {}",
                           map.scale * (high - low), "x y"[axis], side),
               "make the world's size larger or scale smaller");
    return false;
  }
  return true;
}

}  // namespace

int base_of_rooms(const std::vector<Room>& rooms, double scale, int floor) {
  int deepest = rooms.front().high(1);
  for (const Room& room : rooms) deepest = std::max(deepest, room.high(1));
  return floor + rounded(scale * deepest);
}

int base_of_spheres(const std::vector<MovingSphere>& spheres, double scale, int floor) {
  double deepest = spheres.front().centre[1] + spheres.front().radius;
  for (const MovingSphere& s : spheres) deepest = std::max(deepest, s.centre[1] + s.radius);
  return floor + rounded(scale * deepest);
}

VoxelSolids room_columns(const SceneFile& scene, const VoxelMapping& map, Place at,
                         Faults& faults) {
  const vec3& size = map.size;
  const int top = voxel_top(size), rooms = static_cast<int>(scene.rooms.size());
  const int before = faults.count();
  check_storey(scene.rooms, at, faults);
  check_extent(scene.rooms, map, at, faults);
  for (const Room& room : scene.rooms)
    if (!check_room(room, map, at, faults)) break;
  if (faults.count() != before) return {};
  const voxel_column wall{top, top, top, Brick, Brick};
  VoxelSolids solids = filled(wall, wall_of(rooms, East), wall_of(rooms, East), size);
  for (int n = 0; n < rooms; ++n) {
    const Room& room = scene.rooms[static_cast<std::size_t>(n)];
    const Ground ground = ground_of(room, map.scale);
    for (int y = ground.y_low; y < ground.y_high; ++y) {
      set_objects(wall_of(n, West), ground.x_low - 1, y, size, solids);
      set_objects(wall_of(n, East), ground.x_high, y, size, solids);
    }
    for (int x = ground.x_low; x < ground.x_high; ++x) {
      set_objects(wall_of(n, South), x, ground.y_low - 1, size, solids);
      set_objects(wall_of(n, North), x, ground.y_high, size, solids);
    }
  }
  // After all walls: where a wall would be is often a room.
  for (int n = 0; n < rooms; ++n) {
    const Room& room = scene.rooms[static_cast<std::size_t>(n)];
    const Ground ground = ground_of(room, map.scale);
    const voxel_column inside{map.base - rounded(map.scale * room.high(1)),
                              map.base - rounded(map.scale * room.low(1)), top, Sand, Roof};
    for (int y = ground.y_low; y < ground.y_high; ++y)
      for (int x = ground.x_low; x < ground.x_high; ++x) {
        const std::size_t index = wrapped_index(x, y, size);
        solids.columns[index] = packed(inside);
        solids.objects[2 * index] = wall_of(n, Down);
        solids.objects[2 * index + 1] = wall_of(n, Up);
      }
  }
  return solids;
}

VoxelSolids sphere_columns(const std::vector<MovingSphere>& spheres,
                           const std::vector<std::string>& names, const std::vector<int>& materials,
                           int floor, const VoxelMapping& map, Place at, Faults& faults) {
  const vec3& size = map.size;
  const voxel_column ground{floor, floor, floor, Meadow, Meadow};
  VoxelSolids solids = filled(ground, FirstPlane, FirstPlane, size);
  for (std::size_t n = 0; n < spheres.size(); ++n) {
    const Vector3 centre = map.place(spheres[n].centre);
    const double radius = map.scale * spheres[n].radius;
    if (rounded(centre[2] + radius) > voxel_top(size) || 2 * radius > std::min(size[0], size[1])) {
      faults.add(at,
                 fmt::format("sphere {} is up to {:g} high and {:g} wide; the world is {} high and "
                             "{} wide",
                             quoted(names[n]), centre[2] + radius, 2 * radius, voxel_top(size),
                             std::min(size[0], size[1])),
                 "make the world's size larger, or scale or base smaller");
      continue;
    }
    std::vector<bool> told(spheres.size());
    for (int y = column_from(centre[1] - radius); y < column_from(centre[1] + radius); ++y)
      for (int x = column_from(centre[0] - radius); x < column_from(centre[0] + radius); ++x) {
        const double dx = x + 0.5 - centre[0], dy = y + 0.5 - centre[1];
        const double half = std::sqrt(std::max(radius * radius - dx * dx - dy * dy, 0.0));
        const int middle = std::max(rounded(centre[2] - half), floor);
        const int high = rounded(centre[2] + half);
        if (high <= middle) continue;
        const std::size_t index = wrapped_index(x, y, size);
        int& owner = solids.objects[2 * index + 1];
        if (owner != FirstPlane && owner != static_cast<int>(n) &&
            !told[static_cast<std::size_t>(owner)]) {
          told[static_cast<std::size_t>(owner)] = true;
          faults.add(at,
                     "spheres " + quoted(names[static_cast<std::size_t>(owner)]) + " and " +
                         quoted(names[n]) + " are above each other",
                     "a column has one sphere: move one of them");
        }
        owner = static_cast<int>(n);
        solids.columns[index] = packed({floor, middle, high, Meadow, materials[n]});
      }
  }
  return solids;
}

std::vector<VoxelPinhole> room_pinholes(const BeamScene& scene, const VoxelMapping& map) {
  std::vector<VoxelPinhole> all;
  for (int frame = 0; frame < scene.frames(); ++frame) {
    const Camera& camera = scene.file.shot_at(frame).camera;
    const PathPoint& point = scene.path.points[static_cast<std::size_t>(frame)];
    const Vector& centre = scene.file.rooms[static_cast<std::size_t>(point.room)].centre;
    VoxelPinhole pinhole;
    pinhole.position =
        map.place({double(centre[0]) + point.position[0], double(centre[1]) + point.position[1],
                   double(centre[2]) + point.position[2]});
    pinhole.yaw = camera.yaw.value(frame, 0, TurnUnits);
    pinhole.pitch = camera.pitch.value(frame, 0, TurnUnits);
    pinhole.focal_length = camera.fov.value(frame, 0, FocalUnits);
    pinhole.parabolas = true;
    pinhole.shift_x = 1;  // the chip shows the ray of a pixel a column later
    all.push_back(pinhole);
  }
  return all;
}

VoxelPinhole sphere_pinhole(const SphereProgram& program, const VoxelMapping& map) {
  constexpr double One = 4096, ScreenUnit = 32;
  const vec3& eye = program.start.origin;
  VoxelPinhole pinhole;
  pinhole.position = map.place({eye[0] / One, eye[1] / One, eye[2] / One});
  pinhole.focal_length = ScreenUnit * program.start.screen / One - eye[2] / One;
  // The screen's middle stands on the z axis, wherever the eye is.
  pinhole.shift_x = eye[0] / One;
  pinhole.shift_y = eye[1] / One;
  return pinhole;
}

}  // namespace racebeam
